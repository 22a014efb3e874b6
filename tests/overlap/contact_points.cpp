#include <catch2/catch.hpp>

#include <scree/overlap/contact_points.hpp>

#include <tests/support/overlaps.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

std::vector<ContactPoint> points_of(const Placed& a, const Placed& b, double spacing = 1e-4) {
    OverlapWorkspace workspace;
    ContactGeometry g;
    REQUIRE(overlap(a.shape, a.pose, b.shape, b.pose, Detail::force, false, workspace, g));
    const ContactPoints found(a.shape, a.pose, g, workspace, spacing);
    return {found.points().begin(), found.points().end()};
}

}  // namespace

TEST_CASE("A cube on a plane or a table has its four corners for points, in either order", "[overlap]") {
    const double depth = 1e-3;
    const Pose askew{{0.4, -0.3, 1.2}, turned(0.8, {1, -2, 1})};
    const Placed box = moved(placed(cube(0.1), {0, 0, 0.05 - depth}, turned(0.3, Vec3::UnitZ())), askew);
    const Placed table = moved(placed(make_box({1, 1, 1}), {0, 0, -0.5}), askew);
    for (const Placed& other : {moved(ground(), askew), table}) {
        for (const bool swapped : {false, true}) {
            const auto points = swapped ? points_of(other, box) : points_of(box, other);
            REQUIRE(points.size() == 4);
            Vec3 sum = Vec3::Zero();
            for (const ContactPoint& point : points) {
                CHECK(point.depth == Approx(depth).epsilon(1e-9));
                const Vec3 here = askew.inverse() * (swapped ? point.on_a : point.on_b);
                CHECK(std::abs(here.z()) < 1e-12);
                CHECK(here.head<2>().norm() == Approx(0.1 / std::sqrt(2)).epsilon(1e-9));
                CHECK((point.on_b - point.on_a).norm() == Approx(depth).epsilon(1e-9));
                sum += here;
            }
            CHECK(sum.norm() < 1e-9);
        }
    }
}

TEST_CASE("A cube that leans by a hair has all its corners for points", "[overlap]") {
    Random random(90);
    for (int i = 0; i < 20; ++i) {
        const Quat lean = rotation(1e-5 * random.vector());
        const auto points = points_of(placed(cube(0.1), {0, 0, 0.05 - 1e-4}, lean), ground());
        REQUIRE(points.size() == 4);
        for (const ContactPoint& point : points) {
            CHECK(point.depth == Approx(1e-4).epsilon(0.02));
        }
    }
}

TEST_CASE("An edge has two points, a corner one, and crossed edges one in their middle", "[overlap]") {
    const double depth = 1e-3;
    const Quat on_edge = turned(std::atan(1.0), Vec3::UnitX());
    const auto edge = points_of(placed(cube(0.1), {0, 0, 0.05 * std::sqrt(2) - depth}, on_edge), ground());
    REQUIRE(edge.size() == 2);
    CHECK((edge[0].on_a - edge[1].on_a).norm() == Approx(0.1));
    const Quat on_corner = Quat::FromTwoVectors(Vec3(1, 1, 1), Vec3::UnitZ());
    const auto corner =
        points_of(placed(cube(0.1), {0, 0, 0.05 * std::sqrt(3) - depth}, on_corner), ground());
    REQUIRE(corner.size() == 1);
    CHECK((corner[0].on_a - Vec3(0, 0, -depth)).norm() < 1e-12);
    const Placed below =
        placed(cube(0.1), {0, 0, -0.05 * std::sqrt(2)}, turned(2 * std::atan(1.0), Vec3::UnitZ()) * on_edge);
    const auto crossed = points_of(placed(cube(0.1), {0, 0, 0.05 * std::sqrt(2) - depth}, on_edge), below);
    REQUIRE(crossed.size() >= 1);
    CHECK(crossed[0].depth == Approx(depth).epsilon(1e-9));
    CHECK((crossed[0].on_a - Vec3(0, 0, -depth)).norm() < 1e-9);
}

TEST_CASE("Points that are nearer to each other than asked for are one", "[overlap]") {
    const Placed box = placed(cube(0.1), {0, 0, 0.049});
    CHECK(points_of(box, ground(), 0.05).size() == 4);
    CHECK(points_of(box, ground(), 0.12).size() == 2);
    CHECK(points_of(box, ground(), 0.2).size() == 1);
}

TEST_CASE("A round contact has one point, a rod that lies has its two ends", "[overlap]") {
    const double depth = 1e-3;
    const Placed floor = ground();
    const Placed ball = placed(Sphere{0.1}, {0.2, 0, 0.1 - depth});
    for (const bool swapped : {false, true}) {
        const auto points = swapped ? points_of(floor, ball) : points_of(ball, floor);
        REQUIRE(points.size() == 1);
        CHECK(points[0].depth == Approx(depth));
        CHECK(((swapped ? points[0].on_b : points[0].on_a) - Vec3(0.2, 0, -depth)).norm() < 1e-12);
    }
    const auto lens = points_of(placed(Sphere{0.1}, {0, 0, 0.15 - depth}), placed(Sphere{0.05}, {0, 0, 0}));
    REQUIRE(lens.size() == 1);
    CHECK((lens[0].on_b - Vec3(0, 0, 0.05)).norm() < 1e-12);
    const Quat lying = turned(2 * std::atan(1.0), Vec3::UnitX());
    for (const Shape& shape : {Shape(make_frustum(0.1, 0.1, 0.15)), Shape(make_capsule(0.1, 0.15))}) {
        const auto rod = points_of(placed(shape, {0, 0, 0.1 - depth}, lying), floor, 0.02);
        REQUIRE(rod.size() >= 2);
        CHECK(rod[0].depth == Approx(depth).epsilon(1e-3));
        CHECK((rod[0].on_a - rod[1].on_a).norm() == Approx(0.3).epsilon(1e-2));
    }
    const auto standing = points_of(placed(make_capsule(0.1, 0.15), {0, 0, 0.25 - depth}), floor);
    REQUIRE(standing.size() == 1);
    CHECK((standing[0].on_a - Vec3(0, 0, -depth)).norm() < 1e-9);
}

TEST_CASE("The points of any overlap lie in both solids and are as deep as the overlap at most",
          "[overlap]") {
    Random random(91);
    int seen = 0;
    for (int i = 0; i < 300; ++i) {
        const Placed a = placed(random.polyhedron(12), random.vector(-0.3, 0.3), random.rotation());
        const Placed b = placed(random.polyhedron(12), random.direction() * random.uniform(0.8, 1.6));
        const auto g = overlap_of(a, b);
        if (!g) {
            continue;
        }
        ++seen;
        const auto height = [](const Placed& body, const Vec3& point) {
            const Vec3 local = body.pose.inverse() * point;
            double highest = -10;
            for (const Plane& plane : std::get<ConvexPolyhedron>(body.shape).planes) {
                highest = std::max(highest, plane.normal.dot(local) - plane.offset);
            }
            return highest;
        };
        for (const ContactPoint& point : points_of(a, b)) {
            CHECK(point.depth > 0);
            CHECK(point.depth <= g->depth * (1 + 1e-9));
            for (const Vec3& end : {point.on_a, point.on_b}) {
                CHECK(height(a, end) < 1e-9);
                CHECK(height(b, end) < 1e-9);
            }
        }
    }
    CHECK(seen > 100);
}
