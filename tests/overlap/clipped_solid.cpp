#include <catch2/catch.hpp>

#include <scree/overlap/clip.hpp>

#include <tests/overlap/closed_surface.hpp>
#include <tests/support/random.hpp>
#include <tests/support/solids.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("A solid starts with its own faces, edges and tags", "[overlap]") {
    const ConvexPolyhedron solid = icosahedron(1);
    ClippedSolid clipped;
    clipped.start(solid);
    CHECK(clipped.faces().size() == 20);
    CHECK(clipped.half_edges().size() == 60);
    CHECK(clipped.vertices().size() == 12);
    for (std::size_t f = 0; f < 20; ++f) {
        CHECK(clipped.faces()[f].tag == static_cast<int>(f));
    }
    CHECK(surface_fault(clipped).empty());
}

TEST_CASE("A plane beside a solid leaves it as it is, one beyond it leaves nothing", "[overlap]") {
    ClippedSolid clipped;
    clipped.start(cube(2));
    CHECK(clipped.cut({Vec3::UnitX(), 5}, 100));
    CHECK(clipped.cut({Vec3::UnitX(), 1}, 100));  // a face's own plane
    CHECK(clipped.faces().size() == 6);
    CHECK(clipped.vertices().size() == 8);
    CHECK_FALSE(clipped.cut({Vec3::UnitX(), -1.5}, 100));
    CHECK(clipped.vertices().empty());
    CHECK(clipped.faces().empty());
}

TEST_CASE("Each cut closes its hole with a face of its tag", "[overlap]") {
    ClippedSolid clipped;
    clipped.start(cube(2));
    REQUIRE(clipped.cut({Vec3::UnitZ(), 0}, 100));
    CHECK(clipped.faces().size() == 6);
    CHECK(clipped.vertices().size() == 8);
    CHECK(clipped.faces().back().tag == 100);
    REQUIRE(clipped.cut({Vec3(1, 1, 1).normalized(), 0}, 101));
    CHECK(clipped.faces().back().tag == 101);
    CHECK(surface_fault(clipped).empty());
    int across_the_first = 0;
    for (const HalfEdge& edge : clipped.half_edges()) {
        across_the_first += edge.across == 100;
    }
    CHECK(across_the_first >= 3);
}

TEST_CASE("Planes through vertices, along edges and along faces leave a closed surface", "[overlap]") {
    ClippedSolid clipped;
    for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(1, -1, 0), Vec3(2, 1, 0)}) {
        for (const double offset : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
            clipped.start(cube(2));
            const double length = normal.norm();
            if (clipped.cut({normal / length, offset / length}, 100)) {
                CHECK(surface_fault(clipped).empty());
            }
        }
    }
}

TEST_CASE("Cutting again and again by random planes keeps the surface closed", "[overlap]") {
    Random random(41);
    ClippedSolid clipped;
    for (int i = 0; i < 200; ++i) {
        clipped.start(random.polyhedron(20));
        for (int tag = 100; tag < 160; ++tag) {
            const Plane plane{random.direction(), random.uniform(0, 0.4)};
            REQUIRE(clipped.cut(plane, tag));  // the origin stays inside
            CHECK(surface_fault(clipped).empty());
            for (const int v : clipped.vertices()) {
                CHECK(plane.normal.dot(clipped.point(v)) - plane.offset < 1e-15);
            }
        }
    }
}
