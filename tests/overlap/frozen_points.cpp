#include <stdexcept>

#include <catch2/catch.hpp>

#include <scree/overlap/frozen_points.hpp>
#include <scree/overlap/round_spot.hpp>

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

FrozenPoints frozen(const std::vector<FrozenPoint>& points, double area,
                    FrozenPoints::Planes planes = FrozenPoints::Planes::of_b) {
    FrozenPoints geometry;
    geometry.freeze(points, area, planes);
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

TEST_CASE("Planes of A are planes of B seen from the other side", "[overlap]") {
    Random random(63);
    const Placed a = placed(cube(edge), edge * random.vector(), random.rotation());
    const Placed b = placed(cube(edge), edge * random.vector(), random.rotation());
    const std::vector<FrozenPoint> points = random_points(random, a, b, 4);
    std::vector<FrozenPoint> other;
    for (const FrozenPoint& point : points) {
        other.push_back({point.on_b, point.on_a, point.normal, 0, 0, 0});
    }
    const ContactGeometry here = meet(frozen(points, 0.02), a, b).value();
    const ContactGeometry there = meet(frozen(other, 0.02, FrozenPoints::Planes::of_a), b, a).value();
    CHECK(there.volume == here.volume);
    CHECK(deviation(there.centroid, here.centroid, edge) < 1e-14);
    CHECK(there.normal == -here.normal);
}

TEST_CASE("Round surfaces touch where their centres of curvature say, however they are turned", "[overlap]") {
    const double radius = 0.1;
    const double area = 0.02;
    // A ball on a plane, on a block that is A, and on another ball.
    const FrozenPoints on_plane = frozen({{{0, 0, 0}, {0, 0, 0}, Vec3::UnitZ(), radius, 0}}, area);
    const Placed ball = placed(Sphere{radius}, {0.3, 0, radius - depth}, turned(2, {1, 2, 3}));
    const auto resting = meet(on_plane, ball, ground()).value();
    CHECK(resting.volume == Approx(area * depth).epsilon(1e-12));
    CHECK(deviation(resting.centroid, Vec3(0.3, 0, -depth / 2), radius) < 1e-14);
    const FrozenPoints pair = frozen({{{0, 0, 0}, {0, 0, 0}, Vec3::UnitZ(), radius, 0.5 * radius}}, area);
    const Vec3 way = Vec3(1, 2, 2) / 3;
    const auto lens = meet(pair, placed(Sphere{radius}, (1.5 * radius - depth) * way, turned(1, {3, 1, 0})),
                           placed(Sphere{0.5 * radius}, {0, 0, 0}, turned(2, {0, 1, 0})))
                          .value();
    CHECK(lens.depth == Approx(depth).epsilon(1e-12));
    CHECK(deviation(lens.normal, way, 1) < 1e-14);
    CHECK(deviation(lens.centroid, (0.5 * radius - 0.5 * depth) * way, radius) < 1e-14);
}

TEST_CASE("dV, dc, dS, d∫r×n dA and dn agree with differences for frozen points", "[overlap]") {
    Random random(61);
    for (int count = 1; count <= 5; ++count) {
        for (int i = 0; i < 10; ++i) {
            const Placed a = placed(cube(edge), edge * random.vector(), random.rotation());
            const Placed b = placed(cube(edge), edge * random.vector(), random.rotation());
            std::vector<FrozenPoint> set = random_points(random, a, b, count);
            const bool round = i % 2 == 0;
            for (FrozenPoint& point : set) {
                if (round) {  // the same points of both surfaces, by their centres
                    const Vec3 out = b.pose.orientation * point.normal;
                    point.radius_a = random.uniform(0.5, 1) * edge;
                    point.radius_b = random.uniform(0.5, 1) * edge;
                    point.on_a += a.pose.orientation.conjugate() * (point.radius_a * out);
                    point.on_b -= point.radius_b * point.normal;
                }
            }
            const FrozenPoints points = frozen(set, 0.02);
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

TEST_CASE("Slack bears no load, and the load of a point can be asked for", "[overlap]") {
    std::vector<FrozenPoint> points = corners();
    points[0].slack = 0.4 * depth;
    const Placed box = placed(cube(edge), {0, 0, edge / 2 - depth});
    const FrozenPoints set = frozen(points, 0.04);
    CHECK(meet(set, box, ground()).value().volume == Approx(0.01 * depth * 3.6).epsilon(1e-12));
    const auto load = [&](const FrozenPoint& point) {
        return set.load_near(point.on_a, point.on_b, box.pose, Pose(), 0.01).value();
    };
    CHECK(load(points[0]) == Approx(0.6 * depth).epsilon(1e-12));
    CHECK(load(points[3]) == Approx(depth).epsilon(1e-12));
    CHECK_FALSE(set.load_near(Vec3::Zero(), Vec3(0.5, 0, 0), box.pose, Pose(), 0.01).has_value());
    const FrozenPoints exchanged_set = [&] {
        std::vector<FrozenPoint> other;
        for (const FrozenPoint& point : points) {
            other.push_back({point.on_b, point.on_a, point.normal, 0, 0, point.slack});
        }
        return frozen(other, 0.04, FrozenPoints::Planes::of_a);
    }();
    CHECK(exchanged_set.load_near(points[0].on_b, points[0].on_a, Pose(), box.pose, 0.01).value() ==
          Approx(0.6 * depth).epsilon(1e-12));
}

TEST_CASE("Round surfaces have their centres on the axis, ends and corners none", "[overlap]") {
    const auto spot = [](const Shape& shape, const Vec3& point, const Vec3& out) {
        return round_spot(shape, point, out.normalized());
    };
    const RoundSpot ball = spot(Sphere{0.3}, {0, 0.3, 0}, {0, 1, 0});
    CHECK(ball.centre == Vec3::Zero());
    CHECK(ball.radius == 0.3);
    const Shape capsule = make_capsule(0.1, 0.2);
    CHECK(spot(capsule, {0.1, 0, 0.05}, {1, 0, 0}).centre == Vec3(0, 0, 0.05));
    CHECK(deviation(spot(capsule, {0, 0, -0.3}, {0, 0, -1}).centre, Vec3(0, 0, -0.2), 1) < 1e-15);
    const Shape cone = make_frustum(0.1, 0, 0.1);  // its side rises by 2 in 1
    const RoundSpot side = spot(cone, {0, 0.05, 0}, {0, 2, 1});
    CHECK(deviation(side.centre, Vec3(0, 0, -0.025), 0.1) < 1e-15);
    CHECK(side.radius == Approx(std::hypot(0.05, 0.025)));
    CHECK(spot(cone, {0, 0.05, -0.1}, {0, 0, -1}).radius == 0);
    CHECK(spot(cone, {0, 0.1, -0.1}, {0, 1, -1}).radius == 0);
    CHECK(spot(cube(1), {0.5, 0, 0}, {1, 0, 0}).radius == 0);
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
    FrozenPoints points;
    CHECK_THROWS_AS(points.freeze(std::vector<FrozenPoint>(FrozenPoints::most + 1), 1),
                    std::invalid_argument);
}
