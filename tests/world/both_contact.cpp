// One suite for both worlds: bodies that touch. What differs is in differences.cpp.
#include <catch2/catch.hpp>

#include <BulletCollision/CollisionDispatch/btGhostObject.h>

#include <cmath>

#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double tick = 1.0 / 240;

}  // namespace

TEMPLATE_TEST_CASE("both worlds: shapes lie on the ground at their height", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    add_ground(scene);
    btRigidBody& box = add_box(scene, Vec3(0, 0, 0.51));
    btRigidBody& ball = scene.add(1, scene.template shape<btSphereShape>(0.5), Vec3(3, 0, 0.51));
    btRigidBody& can =
        scene.add(1, scene.template shape<btCylinderShapeZ>(btVector3(0.5, 0.5, 0.3)), Vec3(6, 0, 0.31));
    btRigidBody& pill = scene.add(1, scene.template shape<btCapsuleShapeX>(0.3, 1), Vec3(9, 0, 0.31));
    btConvexHullShape& hull = scene.template shape<btConvexHullShape>();
    for (const Vec3& corner : make_box({1, 1, 0.8}).vertices) {
        hull.addPoint(to_bullet(corner));
    }
    hull.setMargin(0);
    btRigidBody& brick = scene.add(1, hull, Vec3(12, 0, 0.41));
    btCompoundShape& table = scene.template shape<btCompoundShape>();
    auto& part = scene.template shape<btBoxShape>(btVector3(0.2, 0.2, 0.2));
    table.addChildShape(to_bullet(Pose{Vec3(0.4, 0, 0), Quat::Identity()}), &part);
    table.addChildShape(to_bullet(Pose{Vec3(-0.4, 0, 0), Quat::Identity()}), &part);
    btRigidBody& pair = scene.add(1, table, Vec3(15, 0, 0.21));
    run(scene, 1.5);
    CHECK(position_of(box).z() == Approx(0.5).margin(2e-3));
    CHECK(position_of(ball).z() == Approx(0.5).margin(2e-3));
    CHECK(position_of(can).z() == Approx(0.3).margin(2e-3));
    CHECK(position_of(pill).z() == Approx(0.3).margin(2e-3));
    CHECK(position_of(brick).z() == Approx(0.4).margin(2e-3));
    CHECK(position_of(pair).z() == Approx(0.2).margin(2e-3));
    for (const btRigidBody* body : {&box, &ball, &can, &pill, &brick, &pair}) {
        CHECK(body->getLinearVelocity().length() < 5e-3);
    }
}

TEMPLATE_TEST_CASE("both worlds: a box slides v²/(2μg) along an axis and stops", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& ground = add_ground(scene);
    btRigidBody& box = add_box(scene, Vec3(0, 0, 0.5));
    ground.setFriction(0.8);
    box.setFriction(0.5);  // the product of the two counts
    run(scene, 0.1);
    box.setLinearVelocity(btVector3(3, 0, 0));
    run(scene, 1.5);
    CHECK(position_of(box).x() == Approx(9 / (2 * 0.4 * 9.81)).epsilon(0.03));
    CHECK(box.getLinearVelocity().length() < 1e-3);
}

TEMPLATE_TEST_CASE("both worlds: masks, flags and filters keep bodies from touching", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btRigidBody& ground = add_ground(scene);
    btRigidBody& kept = add_box(scene, Vec3(0, 0, 0.5));
    btRigidBody& masked = scene.make(1, *kept.getCollisionShape(), Vec3(3, 0, 0.5));
    scene.world->addRigidBody(&masked, 64, 64);
    btRigidBody& ignoring = add_box(scene, Vec3(6, 0, 0.5));
    ignoring.setIgnoreCollisionCheck(&ground, true);
    btRigidBody& ghostly = scene.make(1, *kept.getCollisionShape(), Vec3(9, 0, 0.5));
    ghostly.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
    scene.world->addRigidBody(&ghostly);
    btRigidBody& filtered = add_box(scene, Vec3(12, 0, 0.5));
    filtered.setUserIndex(7);
    struct Filter : btOverlapFilterCallback {
        bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
            const auto index = [](const btBroadphaseProxy& proxy) {
                return static_cast<const btCollisionObject*>(proxy.m_clientObject)->getUserIndex();
            };
            const bool masks = (a->m_collisionFilterGroup & b->m_collisionFilterMask) != 0 &&
                               (b->m_collisionFilterGroup & a->m_collisionFilterMask) != 0;
            return masks && index(*a) != 7 && index(*b) != 7;
        }
    } filter;
    scene.broadphase.getOverlappingPairCache()->setOverlapFilterCallback(&filter);
    scene.world->refreshBroadphaseProxy(&filtered);
    run(scene, 0.5);
    CHECK(position_of(kept).z() == Approx(0.5).margin(2e-3));
    for (const btRigidBody* body : {&masked, &ignoring, &ghostly, &filtered}) {
        CHECK(position_of(*body).z() == Approx(0.5 - 0.125 * 9.81).margin(0.02));
    }
}

TEMPLATE_TEST_CASE("both worlds: a ghost sees what is in it and holds nothing up", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btGhostPairCallback noting;
    scene.broadphase.getOverlappingPairCache()->setInternalGhostPairCallback(&noting);
    btPairCachingGhostObject ghost;
    ghost.setCollisionShape(&scene.template shape<btBoxShape>(btVector3(1, 1, 1)));
    ghost.setCollisionFlags(ghost.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    scene.world->addCollisionObject(&ghost, btBroadphaseProxy::SensorTrigger,
                                    btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::SensorTrigger);
    btRigidBody& box = add_box(scene, Vec3(0, 0, 3), 0.2);
    CHECK(ghost.getNumOverlappingObjects() == 0);
    run(scene, 0.75);
    REQUIRE(ghost.getNumOverlappingObjects() == 1);
    CHECK(ghost.getOverlappingObject(0) == &box);
    run(scene, 0.75);
    CHECK(ghost.getNumOverlappingObjects() == 0);
    CHECK(box.getLinearVelocity().z() == Approx(-9.81 * 1.5).epsilon(1e-3));
    scene.world->removeCollisionObject(&ghost);
}

TEMPLATE_TEST_CASE("both worlds: contact callbacks come when bodies touch, while they do, and when they part",
                   "[both]", BOTH_WORLDS) {
    static int started, ended, added, processed, destroyed;
    started = ended = added = processed = destroyed = 0;
    gContactStartedCallback = [](btPersistentManifold* const&) { ++started; };
    gContactEndedCallback = [](btPersistentManifold* const&) { ++ended; };
    gContactAddedCallback = [](btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                               const btCollisionObjectWrapper*, int, int) {
        ++added;
        point.m_userPersistentData = &added;
        return false;
    };
    gContactProcessedCallback = [](btManifoldPoint&, void*, void*) { return ++processed > 0; };
    gContactDestroyedCallback = [](void*) { return ++destroyed > 0; };
    SceneOf<TestType> scene;
    add_ground(scene);
    btRigidBody& box = add_box(scene, Vec3(0, 0, 0.6));
    box.setCollisionFlags(box.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    run(scene, 0.5);
    CHECK(started >= 1);
    CHECK(ended == started - 1);
    CHECK(added >= 4);
    CHECK(processed >= 4 * 60);
    box.setLinearVelocity(btVector3(0, 0, 10));
    run(scene, 0.5);
    CHECK(ended == started);
    CHECK(destroyed >= 4);
    gContactStartedCallback = gContactEndedCallback = nullptr;
    gContactAddedCallback = nullptr;
    gContactProcessedCallback = nullptr;
    gContactDestroyedCallback = nullptr;
}

TEMPLATE_TEST_CASE("both worlds: a contact's manifold tells the bodies, the normal and the impulse", "[both]",
                   BOTH_WORLDS) {
    SceneOf<TestType> scene;
    const btRigidBody& ground = add_ground(scene);
    const btRigidBody& box = add_box(scene, Vec3(0, 0, 0.5));
    run(scene, 0.5);
    REQUIRE(scene.dispatcher.getNumManifolds() == 1);
    const btPersistentManifold& manifold = *scene.dispatcher.getManifoldByIndexInternal(0);
    const bool box_first = manifold.getBody0() == &box;
    CHECK((box_first ? manifold.getBody1() : manifold.getBody0()) == &ground);
    REQUIRE(manifold.getNumContacts() == 4);
    double impulse = 0;
    for (int i = 0; i < 4; ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        impulse += point.getAppliedImpulse();
        CHECK(point.m_normalWorldOnB.z() == Approx(box_first ? 1 : -1));
        CHECK(std::abs(point.getPositionWorldOnA().x()) == Approx(0.5).margin(1e-2));
        CHECK(std::abs(point.getDistance()) < 2e-3);
    }
    CHECK(impulse == Approx(9.81 * tick).epsilon(0.02));
}

TEMPLATE_TEST_CASE("both worlds: contact tests find what overlaps, and sweeps and rays what is in the way",
                   "[both]", BOTH_WORLDS) {
    struct Count : btCollisionWorld::ContactResultCallback {
        int points = 0;
        btScalar addSingleResult(btManifoldPoint&, const btCollisionObjectWrapper*, int, int,
                                 const btCollisionObjectWrapper*, int, int) override {
            ++points;
            return 0;
        }
    };
    SceneOf<TestType> scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btRigidBody& one = add_box(scene, Vec3(0, 0, 0));
    btRigidBody& other = add_box(scene, Vec3(3, 0, 0));
    run(scene, tick);
    btCollisionObject probe;
    probe.setCollisionShape(&scene.template shape<btSphereShape>(0.3));
    probe.setWorldTransform(to_bullet(Pose{Vec3(0.7, 0, 0), Quat::Identity()}));
    Count all, first, second;
    scene.world->contactTest(&probe, all);
    scene.world->contactPairTest(&probe, &one, first);
    scene.world->contactPairTest(&probe, &other, second);
    CHECK(all.points == first.points);
    CHECK(first.points > 0);
    CHECK(second.points == 0);

    btSphereShape ball(0.25);
    const btVector3 from(-2, 0, 0), to(2, 0, 0);
    btCollisionWorld::ClosestConvexResultCallback sweep(from, to);
    scene.world->convexSweepTest(&ball, btTransform(btQuaternion::getIdentity(), from),
                                 btTransform(btQuaternion::getIdentity(), to), sweep);
    REQUIRE(sweep.hasHit());
    CHECK(sweep.m_hitCollisionObject == &one);
    CHECK(sweep.m_closestHitFraction == Approx(1.25 / 4).margin(1e-3));

    btCollisionWorld::AllHitsRayResultCallback ray(btVector3(-2, 0.1, 0), btVector3(5, 0.1, 0));
    scene.world->rayTest(btVector3(-2, 0.1, 0), btVector3(5, 0.1, 0), ray);
    CHECK(ray.m_collisionObjects.size() == 2);
    btCollisionWorld::ClosestRayResultCallback nearest(btVector3(5, 0.1, 0), btVector3(-2, 0.1, 0));
    scene.world->rayTest(btVector3(5, 0.1, 0), btVector3(-2, 0.1, 0), nearest);
    REQUIRE(nearest.hasHit());
    CHECK(nearest.m_collisionObject == &other);
    CHECK(nearest.m_hitPointWorld.x() == Approx(3.5).margin(1e-3));
    CHECK(nearest.m_hitNormalWorld.x() == Approx(1).margin(1e-3));
}

TEMPLATE_TEST_CASE("both worlds: a compound with its mass centre aside tips where that is beyond the edge",
                   "[both]", BOTH_WORLDS) {
    // A light arm and a heavy end; Bullet wants the children placed about the mass centre.
    const auto [support, tips] = GENERATE(std::pair(0.35, false), std::pair(0.65, true));
    SceneOf<TestType> scene;
    scene.add(0, scene.template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, 0, -0.5));
    btCompoundShape& arm = scene.template shape<btCompoundShape>();
    arm.addChildShape(to_bullet(Pose{Vec3(-0.4, 0, 0), Quat::Identity()}),
                      &scene.template shape<btBoxShape>(btVector3(0.6, 0.1, 0.1)));
    arm.addChildShape(to_bullet(Pose{Vec3(0.3, 0, 0), Quat::Identity()}),
                      &scene.template shape<btBoxShape>(btVector3(0.1, 0.1, 0.1)));
    btRigidBody& body = scene.add(1, arm, Vec3(support, 0, 0.1));
    run(scene, 0.7);
    CHECK((position_of(body).z() < 0) == tips);
    CHECK((body.getAngularVelocity().length() > 0.5) == tips);
}

TEMPLATE_TEST_CASE("both worlds: a kinematic pusher pushes", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    add_ground(scene);
    btRigidBody& box = add_box(scene, Vec3(2, 0, 0.5));
    btDefaultMotionState path(btTransform::getIdentity());
    btRigidBody& pusher =
        scene.make(0, scene.template shape<btBoxShape>(btVector3(0.5, 0.5, 0.4)), Vec3::Zero());
    pusher.setMotionState(&path);
    pusher.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    pusher.setActivationState(DISABLE_DEACTIVATION);
    scene.world->addRigidBody(&pusher);
    for (int i = 1; i <= 480; ++i) {
        path.setWorldTransform(to_bullet(Pose{Vec3(i * tick, 0, 0.45), Quat::Identity()}));
        run(scene, tick);
    }
    CHECK(position_of(pusher).x() == Approx(2));
    CHECK(position_of(box).x() == Approx(3).margin(0.1));
    CHECK(position_of(box).z() == Approx(0.5).margin(5e-3));
}

TEMPLATE_TEST_CASE("both worlds: bodies lie on static triangle meshes and height fields", "[both]",
                   BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btTriangleMesh triangles;
    triangles.addTriangle({-5, -5, 0}, {5, -5, 0}, {5, 5, 0});
    triangles.addTriangle({-5, -5, 0}, {5, 5, 0}, {-5, 5, 0});
    scene.add(0, scene.template shape<btBvhTriangleMeshShape>(&triangles, true), Vec3::Zero());
    btRigidBody& box = add_box(scene, Vec3(0.3, 0.2, 0.55));
    btRigidBody& ball = scene.add(1, scene.template shape<btSphereShape>(0.5), Vec3(3, 0.2, 0.55));
    run(scene, 1);
    CHECK(position_of(box).z() == Approx(0.5).margin(0.05));  // Bullet's margin may hold them up
    CHECK(position_of(ball).z() == Approx(0.5).margin(0.05));
    CHECK(box.getLinearVelocity().length() < 1e-2);
}
