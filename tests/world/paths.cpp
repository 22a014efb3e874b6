#include <catch2/catch.hpp>

#include <scree/dynamics/prescribed_motion.hpp>

#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

std::shared_ptr<const PrescribedPath> path_of(const PrescribedMotion& motion, const Pose& start) {
    return std::make_shared<PrescribedMotionPath>(motion, start);
}

PrescribedMotion swinging() {
    PrescribedMotion motion;
    motion.velocity = {1, 0, 1};
    motion.amplitude = 0.1;
    motion.frequency = 3;
    motion.angular_velocity = {0, 2, 0};
    motion.about = {1, 0, 0};
    return motion;
}

void run(BulletScene& scene, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        CHECK(scene.world->stepSimulation(0.01, 0) == 1);
        INFO(scene.world->step_report().message);
        REQUIRE_FALSE(scene.world->step_report().failed);
    }
}

}  // namespace

TEST_CASE("a body on a path is where that leads, to the last bit, whatever the method") {
    const Method method = GENERATE(Method::bdf, Method::symplectic_euler, Method::velocity_verlet);
    const bool heavy = GENERATE(false, true);  // forces do not matter, nor does a mass
    BulletScene scene;
    SteppingOptions options;
    options.method = method;
    options.fixed_step = method == Method::bdf ? 0 : 1e-3;
    scene.world->set_stepping(options);
    btRigidBody& body = scene.add(heavy ? 3 : 0, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 1));
    scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(3, 0, 0));
    const auto path = path_of(swinging(), {Vec3(0, 0, 1), Quat::Identity()});
    scene.world->set_path(body, path);
    run(scene, 7);
    const PathPoint expected = path->at(scene.world->step_report().time);
    const int number = scene.world->body_number(body);
    const BodyState& state = scene.world->system().states[static_cast<std::size_t>(number)];
    CHECK(state.position == expected.pose.position);
    CHECK(state.orientation.coeffs() == expected.pose.orientation.coeffs());
    CHECK(state.momentum == expected.velocity);
    CHECK(state.angular_momentum == expected.spin);
    CHECK(position_of(body) == expected.pose.position);
    CHECK(to_eigen(body.getLinearVelocity()) == expected.velocity);
}

TEST_CASE("a path may be given and taken away between ticks") {
    BulletScene scene;
    btRigidBody& body = scene.add(0, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 1));
    run(scene, 2);
    PrescribedMotion motion;
    motion.velocity = {1, 0, 0};
    scene.world->set_path(body, path_of(motion, {Vec3(0, 0, 1), Quat::Identity()}));
    run(scene, 3);
    CHECK((position_of(body) - Vec3(0.05, 0, 1)).norm() < 1e-15);  // the path's time is the world's
    scene.world->set_path(body, nullptr);
    run(scene, 3);
    CHECK((position_of(body) - Vec3(0.05, 0, 1)).norm() < 1e-15);
    CHECK(scene.world->system().states[0].momentum == Vec3::Zero());
}

TEST_CASE("a body that is not in the world gets no path") {
    BulletScene scene;
    btRigidBody& body = scene.make(0, scene.box(Vec3::Constant(0.1)), Vec3::Zero());
    CHECK_THROWS_AS(scene.world->set_path(body, nullptr), std::invalid_argument);
}

TEST_CASE("steps follow a vibration that something may meet, and no other") {
    BulletScene scene;
    btRigidBody& plate = scene.add_floor();
    scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.051));
    PrescribedMotion motion;
    motion.velocity = {0, 0, 1};
    motion.amplitude = 1e-6;
    motion.frequency = 200;
    const double far = GENERATE(0, 100);
    scene.world->set_path(plate, path_of(motion, {Vec3(0, 0, -far), Quat::Identity()}));
    scene.world->setGravity(btVector3(0, 0, 0));
    run(scene, 20);
    // A dozen steps in each of 40 periods, or one a tick.
    CHECK((scene.world->step_report().steps.accepted > 480) == (far == 0));
}
