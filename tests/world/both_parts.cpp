// One suite for both worlds: the parts of a world that a program gets at. What differs is in differences.cpp.
#include <catch2/catch.hpp>

#include <cmath>

#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double tick = 0.01;

template <class World>
bool ray_hits(const SceneOf<World>& scene, double x) {
    const btVector3 from(x, 0, 10);
    const btVector3 to(x, 0, -10);
    btCollisionWorld::ClosestRayResultCallback ray(from, to);
    scene.world->rayTest(from, to, ray);
    return ray.hasHit();
}

}  // namespace

TEMPLATE_TEST_CASE("both worlds: a world gives access to its parts", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& fixed = scene.add(0, scene.template shape<btSphereShape>(1), Vec3(0, 0, -2));
    btRigidBody& box = add_box(scene, Vec3::Zero());
    scene.world->setNumTasks(2);
    scene.world->stepSimulation(tick, 1, tick);
    CHECK(scene.world->getCollisionWorld() == scene.world.get());
    CHECK(scene.world->getWorldType() == BT_DISCRETE_DYNAMICS_WORLD);
    CHECK(scene.world->getBroadphase() == &scene.broadphase);
    CHECK(scene.world->getPairCache() == scene.broadphase.getOverlappingPairCache());
    CHECK(scene.world->getDispatcher() == &scene.dispatcher);
    REQUIRE(scene.world->getNonStaticRigidBodies().size() == 1);
    CHECK(scene.world->getNonStaticRigidBodies()[0] == &box);
    CHECK(scene.world->getCollisionObjectArray().findLinearSearch(&fixed) == 0);
}

TEMPLATE_TEST_CASE("both worlds: motion states are brought up to date on demand", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btDefaultMotionState state(btTransform::getIdentity());
    btRigidBody& box =
        scene.make(1, scene.template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3::Zero());
    box.setMotionState(&state);
    scene.world->addRigidBody(&box);
    const auto shown = [&] {
        btTransform place;
        state.getWorldTransform(place);
        return place.getOrigin().x();
    };
    scene.world->stepSimulation(tick, 1, tick);
    const auto put = [&](double x) {
        const btTransform place(btQuaternion::getIdentity(), btVector3(x, 0, 0));
        box.setWorldTransform(place);
        box.setInterpolationWorldTransform(place);
    };
    put(1);
    scene.world->synchronizeSingleMotionState(&box);
    CHECK(shown() == Approx(1));
    put(2);
    scene.world->synchronizeMotionStates();
    CHECK(shown() == Approx(2));
    box.forceActivationState(ISLAND_SLEEPING);
    put(3);
    scene.world->synchronizeMotionStates();
    CHECK(shown() == Approx(2));  // the sleeping ones are left out
    scene.world->setSynchronizeAllMotionStates(true);
    CHECK(scene.world->getSynchronizeAllMotionStates());
    scene.world->synchronizeMotionStates();
    CHECK(shown() == Approx(3));
}

TEMPLATE_TEST_CASE("both worlds: a world without constraints says so", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& box = add_box(scene, Vec3::Zero());
    btPoint2PointConstraint joint(box, btVector3(0, 0, 0));
    CHECK(scene.world->getNumConstraints() == 0);
    scene.world->removeConstraint(&joint);
    CHECK(scene.world->getNumConstraints() == 0);
    scene.world->stepSimulation(tick, 1, tick);
    CHECK(box.getLinearVelocity().z() < 0);
}

TEMPLATE_TEST_CASE("both worlds: forces can be cleared and gravity applied by hand", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& box = add_box(scene, Vec3::Zero());
    const bool weightless = GENERATE(true, false);
    static bool apply;
    apply = !weightless;
    scene.world->setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
            world->clearForces();
            if (apply) {
                static_cast<btDiscreteDynamicsWorld*>(world)->applyGravity();
            }
        },
        nullptr, true);
    scene.world->stepSimulation(tick, 1, tick);
    CHECK(box.getLinearVelocity().z() == Approx(weightless ? 0 : -9.81 * tick).margin(1e-12));
}

TEMPLATE_TEST_CASE("both worlds: vehicles and characters are actions", "[both]", BOTH_WORLDS) {
    struct Action : btActionInterface {
        int updates = 0;
        void updateAction(btCollisionWorld*, btScalar) override { ++updates; }
        void debugDraw(btIDebugDraw*) override {}
    } vehicle, character;
    SceneOf<TestType> scene;
    scene.world->addVehicle(&vehicle);
    scene.world->addCharacter(&character);
    scene.world->stepSimulation(tick, 1, tick);
    scene.world->updateVehicles(tick);
    CHECK(vehicle.updates == 2);
    CHECK(character.updates == 2);
    scene.world->removeVehicle(&vehicle);
    scene.world->removeCharacter(&character);
    scene.world->stepSimulation(tick, 1, tick);
    CHECK(vehicle.updates == 2);
}

TEMPLATE_TEST_CASE("both worlds: a broadphase may be set while the world is empty", "[both]", BOTH_WORLDS) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase first;
    btAxisSweep3 second(btVector3(-100, -100, -100), btVector3(100, 100, 100));
    TestType world(&dispatcher, &first, nullptr, &configuration);
    world.setBroadphase(&second);
    world.setGravity(btVector3(0, 0, -10));
    CHECK(world.getBroadphase() == &second);
    btSphereShape ball(0.5);
    btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
    btRigidBody ground(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
    btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &ball, btVector3(0.1, 0.1, 0.1)));
    body.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 0.6)));
    world.addRigidBody(&ground);
    world.addRigidBody(&body);
    for (int i = 0; i < 100; ++i) {
        world.stepSimulation(tick, 1, tick);
    }
    CHECK(body.getWorldTransform().getOrigin().z() == Approx(0.5).margin(5e-3));
    world.removeRigidBody(&body);
    world.removeRigidBody(&ground);
}

TEMPLATE_TEST_CASE("both worlds: bounds follow a body that was moved", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& box = add_box(scene, Vec3::Zero());
    scene.world->setForceUpdateAllAabbs(true);
    CHECK(scene.world->getForceUpdateAllAabbs());
    scene.world->stepSimulation(tick, 1, tick);
    box.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(5, 0, 0)));
    scene.world->updateSingleAabb(&box);
    CHECK(ray_hits(scene, 5));
    CHECK_FALSE(ray_hits(scene, 0));
    box.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(9, 0, 0)));
    scene.world->updateAabbs();
    CHECK(ray_hits(scene, 9));
    CHECK_FALSE(ray_hits(scene, 5));
}

TEMPLATE_TEST_CASE("both worlds: collisions can be looked for without a step", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    add_box(scene, Vec3::Zero());
    add_box(scene, Vec3(0, 0, 0.99));
    scene.world->updateAabbs();
    scene.world->computeOverlappingPairs();
    CHECK(scene.world->getPairCache()->getNumOverlappingPairs() == 1);
    scene.world->performDiscreteCollisionDetection();
    REQUIRE(scene.dispatcher.getNumManifolds() == 1);
    CHECK(scene.dispatcher.getManifoldByIndexInternal(0)->getNumContacts() == 4);
}

TEMPLATE_TEST_CASE("both worlds: one object alone can be asked", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& box = add_box(scene, Vec3::Zero());
    const auto place = [](double z) { return btTransform(btQuaternion::getIdentity(), btVector3(0, 0, z)); };
    const btVector3 from(0, 0, 3);
    const btVector3 to(0, 0, -3);
    btCollisionWorld::ClosestRayResultCallback ray(from, to), inner(from, to);
    TestType::rayTestSingle(place(3), place(-3), &box, box.getCollisionShape(), box.getWorldTransform(), ray);
    CHECK(ray.m_closestHitFraction == Approx(2.5 / 6));
    const btCollisionObjectWrapper wrap(nullptr, box.getCollisionShape(), &box, box.getWorldTransform(), -1,
                                        -1);
    TestType::rayTestSingleInternal(place(3), place(-3), &wrap, inner);
    CHECK(inner.m_closestHitFraction == ray.m_closestHitFraction);
    btSphereShape ball(0.5);
    btCollisionWorld::ClosestConvexResultCallback sweep(from, to), inner_sweep(from, to);
    TestType::objectQuerySingle(&ball, place(3), place(-3), &box, box.getCollisionShape(),
                                box.getWorldTransform(), sweep, 0);
    CHECK(sweep.m_closestHitFraction == Approx(2.0 / 6).margin(1e-3));
    TestType::objectQuerySingleInternal(&ball, place(3), place(-3), &wrap, inner_sweep, 0);
    CHECK(inner_sweep.m_closestHitFraction == sweep.m_closestHitFraction);
}
