#include <catch2/catch.hpp>

#include <cmath>

#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double tolerance = 3e-3;        // some steps' worth of the default one, 1e-3
const double size = sphere_radius(1e-3);  // of a cube of 0.1 m

void step(BulletScene& scene, int ticks, double tick = 0.01) {
    for (int i = 0; i < ticks; ++i) {
        scene.world->stepSimulation(tick, 1, tick);
    }
    INFO(scene.world->step_report().message);
    REQUIRE_FALSE(scene.world->step_report().failed);
}

}  // namespace

TEST_CASE("a body falls freely, and starts anew from where it is put") {
    BulletScene scene;
    btRigidBody& box = scene.add(2, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 5));
    step(scene, 50);
    CHECK(std::abs(position_of(box).z() - (5 - 0.5 * 9.81 * 0.25)) < tolerance * size);

    box.setCenterOfMassTransform(to_bullet(Pose{Vec3(1, 2, 3), Quat::Identity()}));
    box.setLinearVelocity(btVector3(0, 0, 1));
    step(scene, 50);
    CHECK(position_of(box).x() == Approx(1));
    CHECK(std::abs(position_of(box).z() - (3 + 0.5 - 0.5 * 9.81 * 0.25)) < tolerance * size);

    box.applyCentralImpulse(btVector3(4, 0, 0));
    step(scene, 50);
    CHECK(position_of(box).x() == Approx(2).epsilon(1e-9));
}

TEST_CASE("a body turned from outside keeps its spin") {
    BulletScene scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btRigidBody& box = scene.add(2, scene.box(Vec3(0.1, 0.2, 0.3)), Vec3(0, 0, 5));
    box.setAngularVelocity(btVector3(0, 0, 2));
    step(scene, 1);
    box.setCenterOfMassTransform(
        to_bullet(Pose{Vec3(0, 0, 5), Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()))}));
    step(scene, 1);
    CHECK(box.getAngularVelocity().z() == Approx(2));
}

TEST_CASE("forces and torques hold for a tick") {
    BulletScene scene;
    btRigidBody& box = scene.add(2, scene.box(Vec3::Constant(0.1)), Vec3::Zero());
    const double inertia = 2 * 0.01 / 6;
    for (int i = 0; i < 10; ++i) {
        box.applyCentralForce(btVector3(4, 0, 2 * 9.81));
        box.applyTorque(btVector3(0, 0, inertia));
        step(scene, 1);
    }
    CHECK(std::abs(position_of(box).x() - 0.5 * 2 * 0.01) < tolerance * size);
    CHECK(std::abs(position_of(box).z()) < 1e-12);
    CHECK(box.getAngularVelocity().z() == Approx(0.1));
    step(scene, 10);  // they are gone after stepSimulation
    CHECK(std::abs(box.getLinearVelocity().x() - 0.2) < tolerance * std::sqrt(9.81 * size));
}

TEST_CASE("gravity and damping are each body's own") {
    BulletScene scene;
    btRigidBody& light = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0));
    btRigidBody& damped = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(5, 0, 0));
    light.setGravity(btVector3(0, 0, 1));
    damped.setGravity(btVector3(0, 0, 0));
    damped.setDamping(0.5, 0.75);
    damped.setLinearVelocity(btVector3(1, 0, 0));
    damped.setAngularVelocity(btVector3(0, 0, 1));
    step(scene, 100);
    CHECK(light.getLinearVelocity().z() == Approx(1));
    // Held over a tick, damping lags behind by half of it.
    CHECK(damped.getLinearVelocity().x() == Approx(0.5).epsilon(5e-3));
    CHECK(damped.getAngularVelocity().z() == Approx(0.25).epsilon(2e-2));
}

TEST_CASE("a body that may not turn slides like a point") {
    const bool by_factor = GENERATE(true, false);
    BulletScene scene;
    btRigidBody& floor = scene.add_floor();
    btRigidBody& box = scene.make(1, scene.box(Vec3(0.1, 0.1, 0.4)), Vec3(0, 0, 0.2));
    if (by_factor) {
        box.setAngularFactor(0);
    } else {
        box.setMassProps(1, btVector3(0, 0, 0));
    }
    scene.world->addRigidBody(&box);
    scene.world->set_material(floor, rock(1e9, 0.5));
    scene.world->set_material(box, rock(1e9, 0.5));
    step(scene, 5);
    box.setLinearVelocity(btVector3(2, 0, 0));
    step(scene, 20);
    CHECK(box.getLinearVelocity().x() == Approx(2 - 0.5 * 9.81 * 0.2).epsilon(1e-3));
    CHECK(box.getAngularVelocity().length() < 1e-9);
}

TEST_CASE("a fixed body may be moved, and one may stop being fixed") {
    BulletScene scene;
    btRigidBody& slab = scene.add(0, scene.box(Vec3(1, 1, 0.1)), Vec3(0, 0, -0.05));
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.05));
    step(scene, 20);
    CHECK(scene.world->step_report().contacts == 1);
    slab.setWorldTransform(to_bullet(Pose{Vec3(0, 0, -1), Quat::Identity()}));
    step(scene, 10);
    CHECK(scene.world->step_report().contacts == 0);
    CHECK(position_of(box).z() < 0.02);
    CHECK(position_of(slab).z() == -1);

    slab.setMassProps(3, btVector3(1, 1, 1));
    slab.setCollisionFlags(0);
    slab.setGravity(btVector3(0, 0, -9.81));
    scene.world->removeRigidBody(&slab);
    scene.world->addRigidBody(&slab);
    step(scene, 10);
    CHECK(slab.getLinearVelocity().z() == Approx(-0.981).epsilon(1e-6));
}

TEST_CASE("a body whose simulation is disabled stands still and is stood on") {
    BulletScene scene;
    btRigidBody& lower = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 1));
    btRigidBody& upper = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 1.1));
    lower.forceActivationState(DISABLE_SIMULATION);
    step(scene, 50);
    CHECK(position_of(lower).z() == 1);
    CHECK(position_of(upper).z() == Approx(1.1).epsilon(1e-4));
    lower.forceActivationState(ACTIVE_TAG);
    step(scene, 50);
    CHECK(position_of(lower).z() < 0);
}

TEST_CASE("a body that was put to sleep is awake") {
    BulletScene scene;
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 1));
    box.forceActivationState(ISLAND_SLEEPING);
    step(scene, 10);
    CHECK(box.getLinearVelocity().z() == Approx(-0.981).epsilon(1e-6));
}
