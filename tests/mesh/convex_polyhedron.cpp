#include <scree/mesh/convex_polyhedron.hpp>

#include <stdexcept>

#include <catch2/catch.hpp>

#include <tests/support/random.hpp>
#include <tests/support/shapes.hpp>

using namespace scree;
using Catch::Matchers::Contains;

namespace {

/// Every half-edge's face across holds the same edge the other way round.
bool is_linked(const ConvexPolyhedron& solid) {
    for (int f = 0; f < solid.face_count(); ++f) {
        for (int h = solid.face_begin[f]; h < solid.face_begin[f + 1]; ++h) {
            const int next = h + 1 < solid.face_begin[f + 1] ? h + 1 : solid.face_begin[f];
            const int across = solid.half_edges[h].across;
            bool found = false;
            for (int k = solid.face_begin[across]; k < solid.face_begin[across + 1]; ++k) {
                found = found || (solid.half_edges[k].vertex == solid.half_edges[next].vertex &&
                                  solid.half_edges[k].across == f);
            }
            if (!found) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

TEST_CASE("A box has six outward faces that know their neighbours", "[mesh]") {
    const Vec3 edges(1, 2, 3);
    const ConvexPolyhedron box = make_box(edges);
    REQUIRE(box.vertices.size() == 8);
    REQUIRE(box.face_count() == 6);
    CHECK(box.half_edges.size() == 24);
    CHECK(box.radius == Approx(edges.norm() / 2).epsilon(1e-15));
    CHECK(is_linked(box));
    Vec3 sum = Vec3::Zero();
    for (const Plane& plane : box.planes) {
        CHECK(plane.offset == plane.normal.cwiseAbs().dot(edges) / 2);
        sum += plane.normal.cwiseAbs();
    }
    CHECK(sum == Vec3(2, 2, 2));
}

TEST_CASE("Faces that do not close a solid are refused", "[mesh]") {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    using Loops = std::vector<std::vector<int>>;
    const Loops whole{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    CHECK_NOTHROW(make_polyhedron(corners, whole));

    const auto refused = [&](const Loops& faces, const std::string& why) {
        CHECK_THROWS_WITH(make_polyhedron(corners, faces), Contains(why));
        CHECK_THROWS_AS(make_polyhedron(corners, faces), std::invalid_argument);
    };
    refused({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}, "a face on one side only");
    refused({{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, "used twice in one direction");
    refused({{0, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, "at least three vertices");
    refused({{0, 2, 4}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, "a vertex that is not there");
    CHECK_THROWS_WITH(make_polyhedron({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}}, whole),
                      Contains("no area"));
    CHECK_THROWS_AS(make_box({1, 0, 1}), std::invalid_argument);
}

TEST_CASE("A moved solid has moved vertices and planes", "[mesh]") {
    test::Random random(1);
    const ConvexPolyhedron solid = random.polyhedron(20);
    const Pose motion{random.vector(), random.rotation()};
    const ConvexPolyhedron moved = transformed(solid, motion);
    double radius = 0;
    for (std::size_t v = 0; v < solid.vertices.size(); ++v) {
        CHECK((moved.vertices[v] - motion * solid.vertices[v]).norm() < 1e-15);
        radius = std::max(radius, moved.vertices[v].norm());
    }
    CHECK(moved.radius == radius);
    CHECK(test::height_above(moved, moved.vertices) < 1e-15);
    CHECK(test::unevenness(moved) < 1e-15);
    CHECK(is_linked(moved));
}

TEST_CASE("The plane of a long strip is as even as its coordinates", "[mesh]") {
    test::Random random(2);
    for (const double width : {1e-2, 1e-4}) {
        const ConvexPolyhedron strip = transformed(make_box({1, width, width}), {{}, random.rotation()});
        // The same vertices, but planes computed from them.
        std::vector<std::vector<int>> loops;
        for (int f = 0; f < strip.face_count(); ++f) {
            loops.emplace_back();
            for (int h = strip.face_begin[f]; h < strip.face_begin[f + 1]; ++h) {
                loops.back().push_back(strip.half_edges[h].vertex);
            }
        }
        CHECK(test::unevenness(make_polyhedron(strip.vertices, loops)) < 5e-16);
    }
}
