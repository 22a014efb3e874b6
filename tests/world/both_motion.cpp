// One suite for both worlds, scree's and Bullet's own: how bodies move that touch nothing. What differs is in
// differences.cpp.
#include <catch2/catch.hpp>

#include <cmath>

#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double tick = 1.0 / 240;

template <class World>
void in_one_call(SceneOf<World>& scene, double time) {
    scene.world->stepSimulation(time * (1 + 1e-12), 100000, tick);
}

template <class World>
btRigidBody& add_box(SceneOf<World>& scene, double mass = 2) {
    return scene.add(mass, scene.template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3::Zero());
}

constexpr double inertia = 2 / 6.0;  // of that box

// Where Bullet's steps are off by their first order, half a tick's worth.
double first_order(double acceleration, double time) {
    return 0.51 * acceleration * tick * time + 1e-3;
}

}  // namespace

TEMPLATE_TEST_CASE("both worlds: free fall", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& box = add_box(scene);
    in_one_call(scene, 1);
    CHECK(box.getLinearVelocity().z() == Approx(-9.81).epsilon(1e-6));
    CHECK(std::abs(position_of(box).z() + 0.5 * 9.81) < first_order(9.81, 1));
}

TEMPLATE_TEST_CASE("both worlds: forces and torques hold for a call of stepSimulation, impulses at once",
                   "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btRigidBody& box = add_box(scene);
    box.applyCentralForce(btVector3(4, 0, 0));
    box.applyForce(btVector3(0, 2, 0), btVector3(0.5, 0, 0));
    in_one_call(scene, 0.5);
    CHECK(box.getLinearVelocity().x() == Approx(1).epsilon(1e-6));
    CHECK(box.getAngularVelocity().z() == Approx(0.5 / inertia).epsilon(1e-3));
    in_one_call(scene, 0.5);
    CHECK(box.getLinearVelocity().x() == Approx(1).epsilon(1e-6));
    box.applyTorqueImpulse(btVector3(0, 0, -0.5));
    box.applyCentralImpulse(btVector3(-2, 0, 2));
    in_one_call(scene, 0.5);
    CHECK(box.getLinearVelocity().x() == Approx(0).margin(1e-6));
    CHECK(box.getLinearVelocity().z() == Approx(1).epsilon(1e-6));
    CHECK(box.getAngularVelocity().length() < 1e-3);
}

TEMPLATE_TEST_CASE("both worlds: a force set before a tick, in a callback, acts in that tick and the rest",
                   "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btRigidBody& box = add_box(scene);
    scene.world->setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
            btRigidBody::upcast(world->getCollisionObjectArray()[0])->applyCentralForce(btVector3(2, 0, 0));
        },
        nullptr, true);
    scene.world->stepSimulation(4 * tick * (1 + 1e-12), 4, tick);
    CHECK(box.getLinearVelocity().x() == Approx((1 + 2 + 3 + 4) * tick).epsilon(1e-6));
}

TEMPLATE_TEST_CASE("both worlds: an impulse in a callback after a tick counts from the next on", "[both]",
                   BOTH_WORLDS) {
    SceneOf<TestType> scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btRigidBody& box = add_box(scene);
    scene.world->setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
            auto* body = btRigidBody::upcast(world->getCollisionObjectArray()[0]);
            body->applyCentralImpulse(btVector3(2, 0, 0));
            body->applyTorqueImpulse(btVector3(0, inertia, 0));
        },
        nullptr);
    scene.world->stepSimulation(3 * tick * (1 + 1e-12), 3, tick);
    CHECK(position_of(box).x() == Approx((1 + 2) * tick).epsilon(1e-6));
    CHECK(box.getAngularVelocity().y() == Approx(3).epsilon(1e-6));
}

TEMPLATE_TEST_CASE("both worlds: each body has its gravity, its damping and its factors", "[both]",
                   BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& light = add_box(scene);
    light.setGravity(btVector3(0, 0, -1.62));
    btRigidBody& apart =
        scene.make(2, scene.template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, 5, 0));
    apart.setFlags(apart.getFlags() | BT_DISABLE_WORLD_GRAVITY);
    apart.setDamping(0.4, 0.6);
    scene.world->addRigidBody(&apart);
    apart.setLinearVelocity(btVector3(0, 1, 0));
    apart.setAngularVelocity(btVector3(0, 1, 0));
    btRigidBody& guided =
        scene.add(2, scene.template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, -5, 0));
    guided.setLinearFactor(btVector3(1, 0, 0.5));
    guided.setAngularFactor(btVector3(0, 0, 1));
    guided.setLinearVelocity(btVector3(1, 0, 0));
    guided.applyTorque(btVector3(1, 1, 1));
    in_one_call(scene, 1);
    CHECK(light.getLinearVelocity().z() == Approx(-1.62).epsilon(1e-6));
    CHECK(apart.getLinearVelocity().y() == Approx(0.6).epsilon(1e-3));
    CHECK(apart.getAngularVelocity().y() == Approx(0.4).epsilon(1e-3));
    CHECK(apart.getLinearVelocity().z() == 0);
    CHECK(guided.getLinearVelocity().x() == Approx(1).epsilon(1e-6));
    CHECK(guided.getLinearVelocity().z() == Approx(-0.5 * 9.81).epsilon(1e-3));
    CHECK(guided.getAngularVelocity().z() == Approx(1 / inertia).epsilon(1e-3));
    CHECK(std::abs(guided.getAngularVelocity().x()) < 1e-9);
}

TEMPLATE_TEST_CASE("both worlds: a body goes on from where and how it is set", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& box = add_box(scene);
    in_one_call(scene, 0.5);
    box.setWorldTransform(to_bullet(Pose{Vec3(1, 2, 3), Quat::Identity()}));
    box.setLinearVelocity(btVector3(0, 0, 2));
    box.setAngularVelocity(btVector3(0, 0, 1));
    in_one_call(scene, 0.5);
    CHECK(position_of(box).x() == Approx(1));
    CHECK(std::abs(position_of(box).z() - (3 + 1 - 0.5 * 9.81 * 0.25)) < first_order(9.81, 0.5));
    const Quat turned = to_eigen(box.getWorldTransform()).orientation;
    CHECK(Eigen::AngleAxisd(turned).angle() == Approx(0.5).epsilon(2e-3));
}

TEMPLATE_TEST_CASE("both worlds: a world's gravity set later reaches the bodies that are awake", "[both]",
                   BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& box = add_box(scene);
    scene.world->setGravity(btVector3(1, 0, 0));
    CHECK(scene.world->getGravity() == btVector3(1, 0, 0));
    in_one_call(scene, 1);
    CHECK(box.getLinearVelocity().x() == Approx(1).epsilon(1e-6));
    CHECK(box.getLinearVelocity().z() == 0);
}

TEMPLATE_TEST_CASE("both worlds: a symmetric top keeps its spin", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btRigidBody& disc =
        scene.add(1, scene.template shape<btCylinderShapeZ>(btVector3(0.5, 0.5, 0.1)), Vec3::Zero());
    disc.setAngularVelocity(btVector3(0, 0, 10));
    in_one_call(scene, 1);
    CHECK(disc.getAngularVelocity().z() == Approx(10).epsilon(1e-6));
    const Quat turned = to_eigen(disc.getWorldTransform()).orientation;
    CHECK(std::abs(Eigen::AngleAxisd(turned).angle() - (4 * M_PI - 10)) < 1e-2);
}

TEMPLATE_TEST_CASE("both worlds: a kinematic body goes where its motion state is, and nothing moves it",
                   "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btDefaultMotionState path(btTransform::getIdentity());
    btRigidBody& driven =
        scene.make(0, scene.template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3::Zero());
    driven.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    driven.setActivationState(DISABLE_DEACTIVATION);
    driven.setMotionState(&path);
    scene.world->addRigidBody(&driven);
    btRigidBody& falling =
        scene.add(2, scene.template shape<btBoxShape>(btVector3(0.2, 0.2, 0.2)), Vec3(0, 0, 3));
    for (int i = 1; i <= 120; ++i) {
        path.setWorldTransform(to_bullet(Pose{Vec3(0, 0.5 * i * tick, 0), Quat::Identity()}));
        in_one_call(scene, tick);
    }
    CHECK(position_of(driven).y() == Approx(0.25));
    CHECK(driven.getLinearVelocity().y() == Approx(0.5).epsilon(1e-6));
    CHECK(falling.getLinearVelocity().z() == Approx(-9.81 * 0.5).epsilon(1e-6));
}
