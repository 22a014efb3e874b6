#include <catch2/catch.hpp>

#include <cmath>

#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double tolerance = 3e-3;        // some steps' worth of the default one, 1e-3
const double size = sphere_radius(1e-3);  // of a cube of 0.1 m

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
    CHECK(damped.getLinearVelocity().x() == Approx(0.5).epsilon(tolerance));
    CHECK(damped.getAngularVelocity().z() == Approx(0.25).epsilon(tolerance));
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
    slab.forceActivationState(ACTIVE_TAG);  // Bullet lets what is fixed sleep
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

TEST_CASE("all of a damping of 1 is gone within a tick") {
    BulletScene scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0));
    box.setDamping(1, 1);
    box.setLinearVelocity(btVector3(1, 0, 0));
    box.setAngularVelocity(btVector3(0, 0, 1));
    step(scene, 1);
    CHECK(box.getLinearVelocity().length() < tolerance);
    CHECK(box.getAngularVelocity().length() < tolerance);
}

TEST_CASE("linear and angular factors, forces and impulses are each axis's own") {
    BulletScene scene;
    btRigidBody& box = scene.make(2, scene.box(Vec3(0.1, 0.2, 0.3)), Vec3(0, 0, 1));
    box.setLinearFactor(btVector3(1, 0.5, 0));
    box.setAngularFactor(btVector3(0, 0, 1));
    scene.world->addRigidBody(&box);
    for (int i = 0; i < 10; ++i) {
        box.applyCentralForce(btVector3(4, 4, 4));
        box.applyTorque(btVector3(1, 1, 0.01));
        step(scene, 1);
    }
    CHECK(position_of(box).z() == 1);
    CHECK(box.getLinearVelocity().x() == Approx(0.2).epsilon(tolerance));
    CHECK(box.getLinearVelocity().y() == Approx(0.1).epsilon(tolerance));
    CHECK(box.getAngularVelocity().z() == Approx(0.001 / (2 * 0.05 / 12)).epsilon(tolerance));
    box.applyImpulse(btVector3(2, 0, 2), btVector3(0, 0.1, 0));
    step(scene, 1);
    CHECK(box.getLinearVelocity().x() == Approx(1.2).epsilon(tolerance));
    CHECK(box.getLinearVelocity().z() == 0);
    CHECK(box.getAngularVelocity().x() == 0);
}

TEST_CASE("factors may change while the world runs") {
    BulletScene scene;
    btRigidBody& box = scene.add(2, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 1));
    box.setLinearFactor(btVector3(1, 1, 0));
    step(scene, 10);
    CHECK(position_of(box).z() == 1);
    box.setLinearFactor(btVector3(1, 1, 1));
    step(scene, 10);
    CHECK(std::abs(position_of(box).z() - (1 - 0.5 * 9.81 * 0.01)) < tolerance * size);
}

TEST_CASE("a body that is put elsewhere has no spring from where it was") {
    BulletScene scene;
    scene.world->setGravity(btVector3(3, 0, -9.81));
    btRigidBody& floor = scene.add_floor();
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.05));
    scene.world->set_material(floor, rock(1e9, 0.5));
    scene.world->set_material(box, rock(1e9, 0.5));
    step(scene, 30);
    const Contact& contact = scene.world->system().contacts[0];
    CHECK(contact.history.past[0].force.norm() == Approx(3).epsilon(1e-3));
    const auto before_the_first_step = [&] {
        // Where friction has nothing to hold, only what was remembered could push.
        scene.world->setGravity(btVector3(0, 0, -9.81));
        box.setGravity(btVector3(0, 0, -9.81));
        scene.world->stepSimulation(1e-6, 1, 1e-6);
        return contact.history.past[0].force.norm();
    };
    SECTION("pushed, the spring is still there") {
        box.setLinearVelocity(btVector3(0, 0, 0));
        CHECK(before_the_first_step() > 2.9);
    }
    SECTION("moved, it is not") {
        btTransform place = box.getWorldTransform();
        place.getOrigin().setX(1);
        box.setWorldTransform(place);
        CHECK(before_the_first_step() < 1e-3);
    }
}

TEST_CASE("a shape that is scaled, or a compound that gets a child, is followed") {
    BulletScene scene;
    scene.add_floor();
    btBoxShape& cube = scene.shape<btBoxShape>(btVector3(0.05, 0.05, 0.05));
    btRigidBody& box = scene.add(1, cube, Vec3(0, 0, 0.05));
    btCompoundShape& table = scene.shape<btCompoundShape>();
    table.addChildShape(btTransform::getIdentity(), &scene.box(Vec3::Constant(0.1)));
    btRigidBody& other = scene.add(1, table, Vec3(1, 0, 0.05));
    step(scene, 10);
    cube.setLocalScaling(btVector3(1, 1, 0.5));
    table.addChildShape(to_bullet(Pose{Vec3(0, 0, -0.05), Quat::Identity()}),
                        &scene.box(Vec3::Constant(0.1)));
    other.setWorldTransform(to_bullet(Pose{Vec3(1, 0, 0.2), Quat::Identity()}));
    step(scene, 50);
    CHECK(position_of(box).z() == Approx(0.025).epsilon(1e-3));
    CHECK(position_of(other).z() == Approx(0.1).epsilon(1e-3));
}

TEST_CASE("a force that comes and goes gives its impulse, no more and no less") {
    BulletScene scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btRigidBody& box = scene.add(2, scene.box(Vec3(0.1, 0.2, 0.3)), Vec3::Zero());
    double given = 0;
    for (int i = 0; i < 60; ++i) {
        const double force = i % 3 == 0 ? 5.0 * (i % 7) : 0;
        box.applyCentralForce(btVector3(force, 0, 0));
        box.applyTorque(btVector3(0, 0, 0.01 * force));
        given += 0.01 * force;
        step(scene, 1);
        CHECK(2 * box.getLinearVelocity().x() == Approx(given).epsilon(1e-12));
    }
    CHECK(2 * 0.05 / 12 * box.getAngularVelocity().z() == Approx(0.01 * given).epsilon(1e-9));
}
