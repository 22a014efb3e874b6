#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/dynamics/pair_motion.hpp>
#include <scree/dynamics/prescribed_motion.hpp>

#include <tests/support/finite_difference.hpp>
#include <tests/support/random.hpp>
#include <tests/support/solids.hpp>

using namespace scree;
using namespace scree::test;
using Eigen::VectorXd;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Turning or not, vibrating or not, about a point that is not its own.
PrescribedMotion random_motion(Random& random) {
    PrescribedMotion motion;
    motion.velocity = random.vector();
    motion.about = random.vector();
    if (random.uniform() < 0.7) {
        motion.angular_velocity = 5 * random.vector();
    }
    if (random.uniform() < 0.5) {
        motion.amplitude = random.uniform(0.01, 0.5);
        motion.frequency = random.uniform(0.1, 20);
    }
    return motion;
}

Pose random_pose(Random& random) {
    return {random.vector(), random.rotation()};
}

// Of the points of a ball about the frame's origin, how far any is from where it was.
double farthest(const Pose& from, const Pose& to, double radius, Random& random) {
    double largest = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec3 point = radius * random.direction();
        largest = std::max(largest, (to * point - from * point).norm());
    }
    return largest;
}

}  // namespace

TEST_CASE("A prescribed motion starts exactly where its frame is", "[dynamics]") {
    Random random(261);
    for (int i = 0; i < 50; ++i) {
        const Pose start = random_pose(random);
        const PathPoint point = PrescribedMotionPath(random_motion(random), start).at(0);
        CHECK(point.pose.position == start.position);
        CHECK(point.pose.orientation.coeffs() == start.orientation.coeffs());
    }
}

TEST_CASE("A steady motion goes straight on and round its axis", "[dynamics]") {
    PrescribedMotion motion;
    motion.velocity = {1, 0, 0.5};
    const Pose start{Vec3(2, 1, 0), turned(0.3, Vec3::UnitX())};
    const PathPoint straight = PrescribedMotionPath(motion, start).at(4);
    CHECK(straight.pose.position == Vec3(6, 1, 2));
    CHECK(straight.velocity == motion.velocity);

    // A quarter turn about the vertical axis through (1, 1, 0), which has come 4 s far itself.
    motion.about = {1, 1, 0};
    motion.angular_velocity = {0, 0, std::numbers::pi / 8};
    const PathPoint turning = PrescribedMotionPath(motion, start).at(4);
    CHECK((turning.pose.position - Vec3(1 + 4, 1 + 1, 2)).norm() < 1e-15);
    CHECK(turning.pose.orientation.isApprox(turned(std::numbers::pi / 2, Vec3::UnitZ()) * start.orientation));
    CHECK((turning.velocity - motion.velocity - Vec3(-std::numbers::pi / 8, 0, 0)).norm() < 1e-15);
    CHECK(turning.spin == motion.angular_velocity);
}

TEST_CASE("A vibration goes along the velocity's direction by A sin 2πft", "[dynamics]") {
    PrescribedMotion motion;
    motion.velocity = {0, 3, 4};
    motion.amplitude = 0.1;
    motion.frequency = 2;
    const PrescribedMotionPath path(motion, {});
    const double time = 0.3;
    const double phase = 2 * std::numbers::pi * 2 * time;
    const Vec3 along(0, 0.6, 0.8);
    CHECK((path.at(time).pose.position - 0.1 * std::sin(phase) * along).norm() < 1e-16);
    const double speed = 0.1 * 4 * std::numbers::pi * std::cos(phase);
    CHECK((path.at(time).velocity - speed * along).norm() < 1e-15);
    CHECK(path.time_scale() == Approx(1 / (4 * std::numbers::pi)));
    CHECK(PrescribedMotionPath({}, {}).time_scale() == infinity);
}

TEST_CASE("A path's velocities are the derivatives of its poses, of a tied frame too", "[dynamics]") {
    Random random(262);
    for (int i = 0; i < 50; ++i) {
        const PrescribedMotionPath path(random_motion(random), random_pose(random), random_pose(random));
        const VectorXd time = VectorXd::Constant(1, random.uniform(0, 3));
        const Quat here = path.at(time[0]).pose.orientation;
        const auto place = [&](const VectorXd& t) -> VectorXd {
            const Pose pose = path.at(t[0]).pose;
            VectorXd rows(6);
            rows << pose.position, 2 * (pose.orientation * here.conjugate()).vec();
            return rows;
        };
        VectorXd rate(6);
        rate << path.at(time[0]).velocity, path.at(time[0]).spin;
        CHECK(jacobian_error(place, time, rate, VectorXd::Constant(1, 0.1)) < 1e-8);
    }
}

TEST_CASE("No point within the radius comes farther than the path's reach", "[dynamics]") {
    Random random(263);
    double tightest = 0;
    for (int i = 0; i < 300; ++i) {
        const PrescribedMotionPath path(random_motion(random), random_pose(random), random_pose(random));
        const double begin = random.uniform(0, 3);
        const double end = begin + std::pow(10, random.uniform(-4, 1));
        const double radius = random.uniform(0, 2);
        const double reach = path.reach(begin, end, radius);
        for (int k = 1; k <= 20; ++k) {
            const Pose later = path.at(begin + k * (end - begin) / 20).pose;
            const double moved = farthest(path.at(begin).pose, later, radius, random);
            CHECK(moved <= reach * (1 + 1e-9));
            tightest = std::max(tightest, moved / reach);
        }
    }
    CHECK(tightest > 0.9);  // and it is no excuse for searching everywhere
}

TEST_CASE("A plane that goes straight on has a finite reach, one that turns an infinite one", "[dynamics]") {
    PrescribedMotion motion;
    motion.velocity = {0, 0, 2};
    CHECK(PrescribedMotionPath(motion, {}).reach(1, 3, infinity) == 4);
    motion.angular_velocity = {0, 0, 1};
    CHECK(PrescribedMotionPath(motion, {}).reach(1, 3, infinity) == infinity);
}

TEST_CASE("A conveyor's surface moves in the contact plane only", "[dynamics]") {
    Random random(264);
    const Vec3 normal = random.direction();
    const Vec3 surface = random.vector();
    RelativeMotion motion;
    motion.velocity = random.vector();
    const Vec3 before = motion.velocity;
    add_surface_motion(surface, normal, motion, nullptr);
    const Vec3 added = motion.velocity - before;
    CHECK(std::abs(added.dot(normal)) < 1e-15);
    CHECK((added - surface).cross(normal).norm() < 1e-15);
}
