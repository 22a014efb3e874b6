// One suite for both worlds: what a program calls and gets called by. What differs is in differences.cpp.
#include <catch2/catch.hpp>

#include <cmath>
#include <string>

#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double tick = 0.01;

}  // namespace

TEMPLATE_TEST_CASE("both worlds: stepSimulation counts substeps, and keeps or drops what is left", "[both]",
                   BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& box = add_box(scene, Vec3::Zero());
    scene.world->setGravity(btVector3(0, 0, 0));
    box.setLinearVelocity(btVector3(1, 0, 0));
    CHECK(scene.world->stepSimulation(0.025, 10, tick) == 2);
    CHECK(position_of(box).x() == Approx(0.02));
    CHECK(scene.world->stepSimulation(0.006, 10, tick) == 1);
    CHECK(scene.world->stepSimulation(0.5, 3, tick) == 50);  // of which 3 are made
    CHECK(position_of(box).x() == Approx(0.06));
    CHECK(scene.world->stepSimulation(0.2, 0) == 1);
    CHECK(position_of(box).x() == Approx(0.26));
    CHECK(scene.world->stepSimulation(0) == 0);
}

TEMPLATE_TEST_CASE("both worlds: motion states get what lies between ticks", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btDefaultMotionState state(btTransform::getIdentity());
    btRigidBody& box =
        scene.make(1, scene.template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3::Zero());
    box.setMotionState(&state);
    box.setLinearVelocity(btVector3(1, 0, 0));
    box.setAngularVelocity(btVector3(0, 0, 1));
    scene.world->addRigidBody(&box);
    const bool latency = GENERATE(true, false);
    scene.world->setLatencyMotionStateInterpolation(latency);
    CHECK(scene.world->getLatencyMotionStateInterpolation() == latency);
    scene.world->stepSimulation(0.037, 10, tick);
    btTransform shown;
    state.getWorldTransform(shown);
    CHECK(shown.getOrigin().x() == Approx(latency ? 0.027 : 0.037));
    CHECK(shown.getRotation().getAngle() == Approx(latency ? 0.027 : 0.037).epsilon(1e-3));
    CHECK(position_of(box).x() == Approx(0.03));
}

TEMPLATE_TEST_CASE("both worlds: callbacks and actions come once a tick, in one order", "[both]",
                   BOTH_WORLDS) {
    struct Log : btActionInterface {
        std::string calls;
        void updateAction(btCollisionWorld*, btScalar) override { calls += "a"; }
        void debugDraw(btIDebugDraw*) override {}
    } log;
    SceneOf<TestType> scene;
    add_box(scene, Vec3::Zero());
    scene.world->addAction(&log);
    scene.world->setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) { static_cast<Log*>(world->getWorldUserInfo())->calls += "<"; },
        &log, true);
    scene.world->setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) { static_cast<Log*>(world->getWorldUserInfo())->calls += ">"; },
        &log);
    scene.world->stepSimulation(3 * tick * (1 + 1e-9), 3, tick);
    CHECK(log.calls == "<a><a><a>");
    scene.world->removeAction(&log);
    scene.world->stepSimulation(tick * (1 + 1e-9), 1, tick);
    CHECK(log.calls == "<a><a><a><>");
}

TEMPLATE_TEST_CASE("both worlds: bodies come and go, between ticks and in callbacks", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    add_ground(scene);
    btRigidBody& lower = add_box(scene, Vec3(0, 0, 0.5));
    btRigidBody& upper = add_box(scene, Vec3(0, 0, 1.5));
    run(scene, 0.3, tick);
    scene.world->removeRigidBody(&lower);
    CHECK(scene.world->getNumCollisionObjects() == 2);
    run(scene, 0.8, tick);
    CHECK(position_of(upper).z() == Approx(0.5).margin(0.01));
    CHECK(lower.getBroadphaseHandle() == nullptr);
    lower.setWorldTransform(to_bullet(Pose{Vec3(0, 0, 1.6), Quat::Identity()}));
    lower.setLinearVelocity(btVector3(0, 0, 0));
    scene.world->addRigidBody(&lower);
    run(scene, 0.8, tick);
    CHECK(position_of(lower).z() == Approx(1.5).margin(0.02));

    static btRigidBody* going;
    going = &upper;
    scene.world->setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
            if (going != nullptr) {
                world->removeRigidBody(std::exchange(going, nullptr));
            }
        },
        nullptr);
    run(scene, 0.8, tick);
    CHECK(position_of(lower).z() == Approx(0.5).margin(0.02));
    scene.world->setInternalTickCallback(nullptr);
    scene.world->addRigidBody(&upper);
}

TEMPLATE_TEST_CASE("both worlds: activation states", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& stopped = add_box(scene, Vec3(0, 0, 5));
    btRigidBody& sleeping = add_box(scene, Vec3(5, 0, 5));
    btRigidBody& tireless = add_box(scene, Vec3(10, 0, 5));
    stopped.forceActivationState(DISABLE_SIMULATION);
    sleeping.forceActivationState(ISLAND_SLEEPING);
    tireless.setActivationState(DISABLE_DEACTIVATION);
    run(scene, 0.5, tick);
    CHECK(position_of(stopped).z() == 5);
    CHECK(position_of(sleeping).z() == 5);
    CHECK(sleeping.getActivationState() == ISLAND_SLEEPING);
    CHECK(position_of(tireless).z() < 4);
    CHECK(tireless.getActivationState() == DISABLE_DEACTIVATION);
    sleeping.activate();
    stopped.forceActivationState(ACTIVE_TAG);
    run(scene, 0.5, tick);
    CHECK(position_of(stopped).z() < 4);
    CHECK(position_of(sleeping).z() < 4);
    CHECK(sleeping.getActivationState() == ACTIVE_TAG);
}

TEMPLATE_TEST_CASE("both worlds: a sleeping wall stands until it is hit", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    add_ground(scene);
    std::vector<btRigidBody*> wall;
    for (int i = 0; i < 3; ++i) {
        wall.push_back(&add_box(scene, Vec3(0, 0, 0.5 + i)));
        wall.back()->forceActivationState(ISLAND_SLEEPING);
    }
    btRigidBody& ball = scene.add(5, scene.template shape<btSphereShape>(0.4), Vec3(-8, 0, 4.2));
    ball.setLinearVelocity(btVector3(12, 0, 0));
    run(scene, 0.3, tick);
    for (const btRigidBody* brick : wall) {
        CHECK(brick->getActivationState() == ISLAND_SLEEPING);
        CHECK(brick->getLinearVelocity().length() == 0);
    }
    run(scene, 1, tick);
    CHECK(position_of(*wall[2]).x() > 0.3);
    CHECK(wall[2]->isActive());
}

TEMPLATE_TEST_CASE("both worlds: what users hang on bodies and worlds stays", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& box = add_box(scene, Vec3::Zero());
    int mine = 3;
    box.setUserPointer(&mine);
    box.setUserIndex(4);
    box.setUserIndex2(5);
    scene.world->setWorldUserInfo(&mine);
    run(scene, 0.1, tick);
    CHECK(box.getUserPointer() == &mine);
    CHECK(box.getUserIndex() == 4);
    CHECK(box.getUserIndex2() == 5);
    CHECK(scene.world->getWorldUserInfo() == &mine);
    btRigidBody* seen = btRigidBody::upcast(scene.world->getCollisionObjectArray()[0]);
    REQUIRE(seen == &box);
    scene.world->removeRigidBody(&box);
    CHECK(box.getUserPointer() == &mine);
    scene.world->addRigidBody(&box);
}

TEMPLATE_TEST_CASE("both worlds: a body moves from one world to another with its velocity", "[both]",
                   BOTH_WORLDS) {
    SceneOf<TestType> from, to;
    btRigidBody& box = add_box(from, Vec3(0, 0, 5));
    run(from, 0.5, tick);
    const btVector3 velocity = box.getLinearVelocity();
    from.world->removeRigidBody(&box);
    to.world->setGravity(btVector3(1, 0, 0));
    to.world->addRigidBody(&box);
    CHECK(box.getLinearVelocity() == velocity);
    run(to, 1, tick);
    CHECK(box.getLinearVelocity().x() == Approx(1).epsilon(1e-6));
    CHECK(box.getLinearVelocity().z() == Approx(velocity.z()).epsilon(1e-6));
    to.world->removeRigidBody(&box);
    from.world->addRigidBody(&box);
    run(from, 0.1, tick);
    CHECK(box.getLinearVelocity().x() == Approx(1).epsilon(1e-6));
}

TEMPLATE_TEST_CASE("both worlds: debug drawing shows shapes, bounds and contacts", "[both]", BOTH_WORLDS) {
    struct Drawer : btIDebugDraw {
        int lines = 0, contacts = 0, mode = 0;
        void drawLine(const btVector3&, const btVector3&, const btVector3&) override { ++lines; }
        void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {
            ++contacts;
        }
        void reportErrorWarning(const char*) override {}
        void draw3dText(const btVector3&, const char*) override {}
        void setDebugMode(int wanted) override { mode = wanted; }
        int getDebugMode() const override { return mode; }
    } drawer;
    SceneOf<TestType> scene;
    add_ground(scene);
    add_box(scene, Vec3(0, 0, 0.5));
    run(scene, 0.2, tick);
    scene.world->setDebugDrawer(&drawer);
    CHECK(scene.world->getDebugDrawer() == &drawer);
    drawer.setDebugMode(btIDebugDraw::DBG_DrawContactPoints);
    scene.world->debugDrawWorld();
    CHECK(drawer.contacts == 4);
    CHECK(drawer.lines == 0);
    drawer.setDebugMode(btIDebugDraw::DBG_DrawWireframe | btIDebugDraw::DBG_DrawAabb);
    scene.world->debugDrawWorld();
    CHECK(drawer.lines >= 48);
    scene.world->setDebugDrawer(nullptr);
}
