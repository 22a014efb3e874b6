#include <stdexcept>

#include <catch2/catch.hpp>

#include <scree/overlap/frozen_points.hpp>

#include <tests/overlap/rate_error.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double edge = 0.1;
constexpr double depth = 1e-3;

// The corners of a cube's lowest face against the plane z = 0 under it.
std::vector<FrozenPoint> corners() {
    std::vector<FrozenPoint> points;
    for (const double x : {-edge / 2, edge / 2}) {
        for (const double y : {-edge / 2, edge / 2}) {
            points.push_back({{x, y, -edge / 2}, {x, y, 0}, Vec3::UnitZ()});
        }
    }
    return points;
}

FrozenPoints frozen(const std::vector<FrozenPoint>& points, double area) {
    FrozenPoints geometry(area);
    geometry.freeze(points);
    return geometry;
}

std::optional<ContactGeometry> meet(const FrozenPoints& points, const Placed& a, const Placed& b) {
    OverlapWorkspace workspace;
    ContactGeometry g;
    if (!points.geometry(a.pose, b.pose, Detail::derivative, false, workspace, g)) {
        return std::nullopt;
    }
    g.centroid += a.pose.position;
    return g;
}

// Random points about a pose of A, sunk in by about the depth, along normals that differ by some degrees.
std::vector<FrozenPoint> random_points(Random& random, const Placed& a, const Placed& b, int count) {
    std::vector<FrozenPoint> points;
    const Vec3 up = random.direction();
    for (int i = 0; i < count; ++i) {
        const Vec3 normal = (up + 0.1 * random.vector()).normalized();
        const Vec3 at = a.pose.position + edge * random.vector();
        const Vec3 sideways = 0.1 * depth * random.vector();  // one body has slid since they were found
        const Vec3 above = at + random.uniform(0.5, 1.5) * depth * normal + sideways;
        points.push_back(
            {a.pose.inverse() * at, b.pose.inverse() * above, b.pose.orientation.conjugate() * normal});
    }
    return points;
}

}  // namespace

TEST_CASE("A cube on four frozen points is a spring of stiffness Y Lc on as many shares", "[overlap]") {
    const double area = 0.03;
    const FrozenPoints points = frozen(corners(), area);
    const auto g = meet(points, placed(cube(edge), {0, 0, edge / 2 - depth}), ground()).value();
    CHECK(g.volume == Approx(area * depth).epsilon(1e-12));
    CHECK(g.area == Approx(area).epsilon(1e-14));
    CHECK(deviation(g.normal, Vec3::UnitZ(), 1) < 1e-15);
    CHECK(deviation(g.centroid, Vec3(0, 0, -depth / 2), edge) < 1e-14);
    CHECK(g.depth == Approx(depth).epsilon(1e-12));
    CHECK(g.depth_moment == Approx(area * depth * depth / 2).epsilon(1e-12));
    CHECK(g.lever == Approx(edge / std::sqrt(2)).epsilon(1e-14));
    CHECK(g.flat_patch);

    // Tilted until two corners are out, half the shares are left.
    const auto tilted = meet(points, placed(cube(edge), {0, 0, edge / 2}, turned(0.02, {1, 0, 0})), ground());
    CHECK(tilted.value().area == Approx(area / 2).epsilon(1e-14));
    CHECK(tilted.value().depth == Approx(edge / 2 * (std::sin(0.02) + std::cos(0.02) - 1)).epsilon(1e-12));
    CHECK_FALSE(meet(points, placed(cube(edge), {0, 0, edge / 2 + depth}), ground()).has_value());
    CHECK_FALSE(meet(frozen({}, area), placed(cube(edge), {0, 0, 0}), ground()).has_value());
}

TEST_CASE("dV, dc, dS, d∫r×n dA and dn agree with differences for frozen points", "[overlap]") {
    Random random(61);
    for (int count = 1; count <= 5; ++count) {
        for (int i = 0; i < 10; ++i) {
            const Placed a = placed(cube(edge), edge * random.vector(), random.rotation());
            const Placed b = placed(cube(edge), edge * random.vector(), random.rotation());
            const FrozenPoints points = frozen(random_points(random, a, b, count), 0.02);
            const Meeting meeting = [&](const Placed& one, const Placed& other) {
                return meet(points, one, other).value();
            };
            CHECK(derivative_error(a, b, 0.1 * depth, edge, meeting) < 1e-8);
        }
    }
}

TEST_CASE("Frozen points are turned and moved with the two bodies", "[overlap]") {
    Random random(62);
    const Placed a = placed(cube(edge), random.vector(), random.rotation());
    const Placed b = placed(cube(edge), random.vector(), random.rotation());
    const FrozenPoints points = frozen(random_points(random, a, b, 4), 0.02);
    const ContactGeometry here = meet(points, a, b).value();
    const Pose motion{100 * random.vector(), random.rotation()};
    const ContactGeometry there = meet(points, moved(a, motion), moved(b, motion)).value();
    CHECK(there.volume == Approx(here.volume).epsilon(1e-9));
    CHECK(deviation(there.centroid, motion * here.centroid, edge) < 1e-10);
    CHECK(deviation(there.normal, motion.orientation * here.normal, 1) < 1e-12);
}

TEST_CASE("Frozen points that push against each other fall back to the line of centres", "[overlap]") {
    const FrozenPoints points = frozen(
        {{{0, 0, -edge}, {0, 0, -edge + depth}, {0, 0, 1}}, {{0, 0, edge}, {0, 0, edge - depth}, {0, 0, -1}}},
        0.01);
    const auto g = meet(points, placed(cube(edge), {0, 0, 0}), ground()).value();
    CHECK(g.centre_line);
    CHECK(finite(g));
}

TEST_CASE("More frozen points than a contact can have are refused", "[overlap]") {
    FrozenPoints points(1);
    CHECK_THROWS_AS(points.freeze(std::vector<FrozenPoint>(FrozenPoints::most + 1)), std::invalid_argument);
}
