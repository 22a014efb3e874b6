#include <catch2/catch.hpp>

#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("an empty world lets time pass") {
    BulletScene scene;
    CHECK(scene.world->stepSimulation(0.1, 10, 0.01) == 10);
    CHECK(scene.world->step_report().time == 10 * 0.01);
    CHECK_FALSE(scene.world->step_report().failed);
    CHECK(scene.world->contact_results().empty());
    scene.add_floor();
    scene.world->stepSimulation(0.1, 10, 0.01);
    CHECK(scene.world->step_report().time == 20 * 0.01);
    CHECK(scene.world->step_report().contacts == 0);
}

TEST_CASE("ticks end on multiples of their length") {
    BulletScene scene;
    scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3::Zero());
    for (int i = 1; i <= 100; ++i) {
        scene.world->stepSimulation(0.1 * i - 0.1 * (i - 1), 0);
        CHECK(scene.world->step_report().time == 0.1 * i);
    }
    CHECK(scene.world->step_report().ticks == 100);
    scene.world->stepSimulation(0.05, 0);
    CHECK(scene.world->step_report().time == 0.1 * 100 + 0.05);
}

TEST_CASE("substeps are counted and dropped as Bullet does") {
    BulletScene scene;
    btDiscreteDynamicsWorld stock(&scene.dispatcher, &scene.broadphase, nullptr, &scene.configuration);
    for (const auto& [time, most, tick] :
         {std::tuple(0.05, 10, 0.01), std::tuple(0.004, 10, 0.01), std::tuple(0.5, 3, 0.01),
          std::tuple(0.007, 0, 0.01), std::tuple(0.0, 1, 0.01)}) {
        CHECK(scene.world->stepSimulation(time, most, tick) == stock.stepSimulation(time, most, tick));
    }
}

TEST_CASE("callbacks and actions come in Bullet's order and see the tick's results") {
    struct Log : btActionInterface {
        std::string calls;
        const btRigidBody* body = nullptr;
        double before = 0;
        void updateAction(btCollisionWorld* /*world*/, btScalar tick) override {
            CHECK(tick == 0.01);
            calls += "a";
            CHECK(body->getCenterOfMassPosition().z() < before);
        }
        void debugDraw(btIDebugDraw* /*drawer*/) override {}
    };
    BulletScene scene;
    Log log;
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3::Zero());
    log.body = &box;
    scene.world->addAction(&log);
    scene.world->setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
            auto* to = static_cast<Log*>(world->getWorldUserInfo());
            to->calls += "<";
            to->before = to->body->getCenterOfMassPosition().z();
        },
        &log, true);
    scene.world->setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) { static_cast<Log*>(world->getWorldUserInfo())->calls += ">"; },
        &log);
    scene.world->stepSimulation(0.02, 2, 0.01);
    CHECK(log.calls == "<a><a>");
}

TEST_CASE("motion states get interpolated transforms") {
    BulletScene scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btDefaultMotionState state(btTransform::getIdentity());
    btRigidBody& box = scene.make(1, scene.box(Vec3::Constant(0.1)), Vec3::Zero());
    box.setMotionState(&state);
    box.setLinearVelocity(btVector3(1, 0, 0));
    scene.world->addRigidBody(&box);
    scene.world->stepSimulation(0.015, 10, 0.01);
    CHECK(box.getCenterOfMassPosition().x() == Approx(0.01));
    btTransform shown;
    state.getWorldTransform(shown);
    CHECK(shown.getOrigin().x() == Approx(0.005));  // a tick behind, unless latency is switched off
    scene.world->setLatencyMotionStateInterpolation(false);
    scene.world->stepSimulation(0.01, 10, 0.01);
    state.getWorldTransform(shown);
    CHECK(shown.getOrigin().x() == Approx(0.025));
}

TEST_CASE("rays meet bodies where they are") {
    BulletScene scene;
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 10));
    box.setLinearVelocity(btVector3(0, 0, -20));
    for (int i = 0; i < 20; ++i) {
        scene.world->stepSimulation(0.01, 1, 0.01);
        const btVector3 from(-1, 0, box.getCenterOfMassPosition().z());
        btCollisionWorld::ClosestRayResultCallback hit(from, -from);
        scene.world->rayTest(from, btVector3(1, 0, from.z()), hit);
        REQUIRE(hit.hasHit());
        CHECK(hit.m_collisionObject == &box);
    }
    box.setCenterOfMassTransform(to_bullet(Pose{Vec3(0, 5, 0), Quat::Identity()}));
    scene.world->updateAabbs();
    btCollisionWorld::ClosestRayResultCallback hit(btVector3(-1, 5, 0), btVector3(1, 5, 0));
    scene.world->rayTest(btVector3(-1, 5, 0), btVector3(1, 5, 0), hit);
    CHECK(hit.hasHit());
}
