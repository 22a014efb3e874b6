#include <catch2/catch.hpp>

#include <limits>

#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("what the world cannot do is refused when it is added") {
    BulletScene scene;
    btCollisionShape& box = scene.box(Vec3::Constant(0.1));
    const auto refused = [&](btRigidBody& body) {
        const int objects = scene.world->getNumCollisionObjects();
        const int moving = scene.world->getNonStaticRigidBodies().size();
        CHECK_THROWS_AS(scene.world->addRigidBody(&body), std::invalid_argument);
        CHECK_THROWS_AS(scene.world->addRigidBody(&body, 1, -1), std::invalid_argument);
        CHECK(scene.world->getNumCollisionObjects() == objects);
        CHECK(scene.world->getNonStaticRigidBodies().size() == moving);
    };
    SECTION("shapes") {
        const btVector3 centre(0, 0, 0);
        const btScalar radius = 1;
        btRigidBody& balls =
            scene.make(1, scene.shape<btMultiSphereShape>(&centre, &radius, 1), Vec3::Zero());
        refused(balls);
        CHECK(scene.world->body_number(balls) == -1);
    }
    SECTION("a plane that falls") {
        refused(scene.make(1, scene.shape<btStaticPlaneShape>(btVector3(0, 0, 1), 0), Vec3::Zero()));
    }
    SECTION("additional damping, which would leave a push of a millimetre a second without effect") {
        btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &box, btVector3(1, 1, 1));
        info.m_additionalDamping = true;
        btRigidBody damped(info);
        CHECK_THROWS_WITH(scene.world->addRigidBody(&damped), Catch::Contains("m_additionalDamping"));
        refused(damped);
        CHECK(scene.world->body_number(damped) == -1);
    }
    SECTION("a body that is there already") {
        refused(scene.add(1, box, Vec3::Zero()));
    }
    SECTION("soft bodies, fluids and multibodies") {
        struct OfType : btCollisionObject {
            explicit OfType(int type) { m_internalType = type; }
        };
        for (const int type : {btCollisionObject::CO_SOFT_BODY, btCollisionObject::CO_HF_FLUID,
                               btCollisionObject::CO_FEATHERSTONE_LINK}) {
            OfType object(type);
            object.setCollisionShape(&box);
            CHECK_THROWS_WITH(scene.world->addCollisionObject(&object), Catch::Contains("multibodies"));
            CHECK(scene.world->getNumCollisionObjects() == 0);
        }
    }
    SECTION("joints") {
        btPoint2PointConstraint joint(scene.add(1, box, Vec3::Zero()), btVector3(0, 0, 0));
        CHECK_THROWS_AS(scene.world->addConstraint(&joint), std::invalid_argument);
        CHECK(scene.world->getNumConstraints() == 0);
    }
    SECTION("an explicit method without a step") {
        SteppingOptions options;
        options.method = Method::velocity_verlet;
        CHECK_THROWS_AS(scene.world->set_stepping(options), std::invalid_argument);
    }
}

TEST_CASE("a tick that cannot be done says why, and no more are done") {
    BulletScene scene;
    scene.add_floor();
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 1));
    CHECK(scene.world->stepSimulation(0.05, 10, 0.01) == 5);
    const StepReport& report = scene.world->step_report();
    REQUIRE_FALSE(report.failed);

    SECTION("a velocity that is no number") {
        box.setLinearVelocity(btVector3(std::numeric_limits<double>::quiet_NaN(), 0, 0));
        CHECK(scene.world->stepSimulation(0.05, 10, 0.01) == 0);
        CHECK_THAT(report.message, Catch::Contains("body 1") && Catch::Contains("not finite"));
    }
    SECTION("a shape that is not done") {
        box.setCollisionShape(&scene.shape<btEmptyShape>());
        CHECK(scene.world->stepSimulation(0.05, 10, 0.01) == 0);
        CHECK_THAT(report.message, Catch::Contains("Empty"));
    }
    SECTION("a failure in the middle") {
        scene.world->setInternalTickCallback(
            [](btDynamicsWorld* world, btScalar) {
                if (static_cast<DynamicsWorld*>(world)->step_report().ticks == 7) {
                    btCollisionObject* body = world->getCollisionObjectArray()[1];
                    btRigidBody::upcast(body)->setAngularVelocity(btVector3(INFINITY, 0, 0));
                }
            },
            nullptr);
        CHECK(scene.world->stepSimulation(0.05, 10, 0.01) == 2);
        CHECK(report.time == Approx(0.07));
    }
    CHECK(report.failed);
    const double height = box.getCenterOfMassPosition().z();
    CHECK(scene.world->stepSimulation(0.05, 10, 0.01) == 0);
    CHECK(box.getCenterOfMassPosition().z() == height);
}
