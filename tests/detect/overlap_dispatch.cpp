#include <catch2/catch.hpp>

#include <BulletCollision/CollisionDispatch/btBoxBoxCollisionAlgorithm.h>

#include <cmath>
#include <memory>
#include <thread>

#include <scree/detect/collision_shapes.hpp>
#include <scree/detect/convert.hpp>
#include <scree/detect/overlap_dispatch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/solids.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Bullet's collision world alone, with the overlap in its dispatcher.
struct Scene {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btCollisionWorld world{&dispatcher, &broadphase, &configuration};
    std::shared_ptr<OverlapDispatch> overlaps = OverlapDispatch::of(dispatcher);
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::vector<std::unique_ptr<btCollisionObject>> objects;

    Scene() = default;
    ~Scene() {
        for (const auto& object : objects) {
            world.removeCollisionObject(object.get());
        }
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    template <class ShapeType, class... Arguments>
    ShapeType& shape(Arguments&&... arguments) {
        shapes.push_back(std::make_unique<ShapeType>(std::forward<Arguments>(arguments)...));
        return static_cast<ShapeType&>(*shapes.back());
    }
    btCollisionObject& add(btCollisionShape& shape, const Vec3& position,
                           const Quat& turn = Quat::Identity()) {
        objects.push_back(std::make_unique<btCollisionObject>());
        objects.back()->setCollisionShape(&shape);
        objects.back()->setCollisionFlags(btCollisionObject::CF_DYNAMIC_OBJECT);
        objects.back()->setWorldTransform(to_bullet(Pose{position, turn}));
        world.addCollisionObject(objects.back().get());
        return *objects.back();
    }
    btCollisionObject& add_floor() {
        return add(shape<btStaticPlaneShape>(btVector3(0, 0, 1), 0), {0, 0, 0});
    }
    void move(btCollisionObject& object, const Vec3& position, const Quat& turn = Quat::Identity()) {
        object.setWorldTransform(to_bullet(Pose{position, turn}));
        world.performDiscreteCollisionDetection();
    }
    // The manifolds that have points.
    std::vector<btPersistentManifold*> touching() {
        std::vector<btPersistentManifold*> found;
        for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
            if (dispatcher.getManifoldByIndexInternal(i)->getNumContacts() > 0) {
                found.push_back(dispatcher.getManifoldByIndexInternal(i));
            }
        }
        return found;
    }
};

struct Points : btCollisionWorld::ContactResultCallback {
    std::vector<btManifoldPoint> points;
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* /*a*/, int /*part_a*/,
                             int /*index_a*/, const btCollisionObjectWrapper* /*b*/, int /*part_b*/,
                             int /*index_b*/) override {
        points.push_back(point);
        return 0;
    }
};

// Counts Bullet's callbacks, which are global, while it lives.
struct Events {
    static inline int started, ended, added, processed, destroyed;
    Events() {
        started = ended = added = processed = destroyed = 0;
        gContactStartedCallback = [](btPersistentManifold* const& /*manifold*/) { ++started; };
        gContactEndedCallback = [](btPersistentManifold* const& /*manifold*/) { ++ended; };
        gContactAddedCallback = [](btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                                   const btCollisionObjectWrapper*, int, int) {
            ++added;
            if (point.m_userPersistentData == nullptr) {
                point.m_userPersistentData = &added;
            }
            return true;
        };
        gContactProcessedCallback = [](btManifoldPoint& /*point*/, void* /*a*/, void* /*b*/) {
            ++processed;
            return true;
        };
        gContactDestroyedCallback = [](void* /*data*/) {
            ++destroyed;
            return true;
        };
    }
    ~Events() {
        gContactStartedCallback = nullptr;
        gContactEndedCallback = nullptr;
        gContactAddedCallback = nullptr;
        gContactProcessedCallback = nullptr;
        gContactDestroyedCallback = nullptr;
    }
    Events(const Events&) = delete;
    Events& operator=(const Events&) = delete;
};

}  // namespace

TEST_CASE("a manifold gets the corners of the overlap's patch") {
    Scene scene;
    btCollisionObject& floor = scene.add_floor();
    btCollisionObject& box = scene.add(scene.shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(3, 0, 0.499),
                                       turned(0.3, Vec3::UnitZ()));
    scene.world.performDiscreteCollisionDetection();
    const auto manifolds = scene.touching();
    REQUIRE(manifolds.size() == 1);
    REQUIRE(manifolds[0]->getNumContacts() == 4);
    const double sign = manifolds[0]->getBody0() == &box ? 1 : -1;
    CHECK((manifolds[0]->getBody0() == &floor || manifolds[0]->getBody1() == &floor));
    for (int i = 0; i < 4; ++i) {
        const btManifoldPoint& point = manifolds[0]->getContactPoint(i);
        CHECK(point.getDistance() == Approx(-1e-3).epsilon(1e-9));
        CHECK((to_eigen(point.m_normalWorldOnB) - sign * Vec3::UnitZ()).norm() < 1e-12);
        CHECK((to_eigen(point.getPositionWorldOnB()) - Vec3(3, 0, 0)).norm() ==
              Approx(std::sqrt(0.5)).epsilon(1e-3));
    }
}

TEST_CASE("all pairs of shapes that overlap touch, whatever Bullet calls them") {
    Scene scene;
    const btVector3 half(0.5, 0.5, 0.5);
    btCompoundShape& compound = scene.shape<btCompoundShape>();
    compound.addChildShape(to_bullet(Pose{Vec3(0, 0.2, 0), Quat::Identity()}),
                           &scene.shape<btBoxShape>(half));
    compound.addChildShape(to_bullet(Pose{Vec3(0, -0.2, 0), Quat::Identity()}),
                           &scene.shape<btSphereShape>(0.5));
    btCollisionShape* shapes[] = {
        &scene.shape<btBoxShape>(half),
        &scene.shape<btSphereShape>(0.5),
        &scene.shape<btCapsuleShapeX>(0.5, 1),
        &scene.shape<btCylinderShapeZ>(half),
        &scene.shape<btConeShapeZ>(0.5, 1),
        &scene.shape<PolyhedronShape>(std::make_shared<const Shape>(icosahedron(0.6))),
        &compound};
    for (btCollisionShape* a : shapes) {
        for (btCollisionShape* b : shapes) {
            btCollisionObject& upper = scene.add(*a, Vec3(0, 0, 0.93));
            btCollisionObject& lower = scene.add(*b, Vec3(0, 0, 0));
            Points points;
            scene.world.contactPairTest(&upper, &lower, points);
            CAPTURE(a->getName(), b->getName());
            REQUIRE_FALSE(points.points.empty());
            for (const btManifoldPoint& point : points.points) {
                CHECK(point.getDistance() < 0);
                CHECK(point.getDistance() > -0.2);
            }
            scene.world.performDiscreteCollisionDetection();
            CHECK_FALSE(scene.touching().empty());
            for (int i = 0; i < 2; ++i) {
                scene.world.removeCollisionObject(scene.objects.back().get());
                scene.objects.pop_back();
            }
            CHECK(scene.dispatcher.getNumManifolds() == 0);
        }
    }
}

TEST_CASE("contact tests see the overlap, and the distance of shapes that are apart") {
    Scene scene;
    btCollisionShape& box = scene.shape<btBoxShape>(btVector3(0.5, 0.5, 0.5));
    btCollisionObject& lower = scene.add(box, Vec3(0, 0, 0));
    btCollisionObject& upper = scene.add(box, Vec3(0.2, 0, 0.99));
    Points pair, all;
    scene.world.contactPairTest(&upper, &lower, pair);
    CHECK(pair.points.size() == 4);
    scene.world.contactTest(&upper, all);
    CHECK(all.points.size() == 4);
    for (const btManifoldPoint& point : pair.points) {
        CHECK(point.getDistance() == Approx(-0.01).epsilon(1e-3));  // along the overlap's own normal
    }
    CHECK(scene.dispatcher.getNumManifolds() == 0);

    scene.move(upper, Vec3(0, 0, 1.1));
    Points apart;
    scene.world.contactPairTest(&upper, &lower, apart);
    CHECK(apart.points.empty());
    apart.m_closestDistanceThreshold = 0.5;
    scene.world.contactPairTest(&upper, &lower, apart);
    REQUIRE_FALSE(apart.points.empty());
    CHECK(apart.points[0].getDistance() == Approx(0.1).epsilon(1e-6));
}

TEST_CASE("callbacks come as contacts start, go on and end") {
    const Events events;
    Scene scene;
    scene.add_floor();
    btCollisionObject& box = scene.add(scene.shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, 0, 0.6));
    box.setCollisionFlags(box.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    scene.world.performDiscreteCollisionDetection();
    CHECK(Events::started == 0);
    CHECK(scene.touching().empty());

    scene.move(box, Vec3(0, 0, 0.499));
    CHECK(Events::started == 1);
    CHECK(Events::added == 4);
    const int processed = Events::processed;
    CHECK(processed == 4);
    // Sliding on, the corners are the same points to Bullet's user.
    for (int i = 1; i <= 10; ++i) {
        scene.move(box, Vec3(0.1 * i, 0, 0.499));
    }
    CHECK(Events::started == 1);
    CHECK(Events::ended == 0);
    CHECK(Events::destroyed == 0);
    CHECK(Events::processed == processed + 40);
    REQUIRE(scene.touching().size() == 1);
    CHECK(scene.touching()[0]->getNumContacts() == 4);
    CHECK(scene.touching()[0]->getContactPoint(0).getLifeTime() > 10);

    // Onto another face: all points are others, but the contact never ends in between.
    scene.move(box, Vec3(1, 0, 0.499), turned(M_PI, Vec3::UnitX()));
    CHECK(Events::destroyed == 4);
    CHECK(Events::ended == 0);
    CHECK(Events::started == 1);
    CHECK(scene.touching()[0]->getNumContacts() == 4);
    scene.move(box, Vec3(1, 0, 0.52));
    CHECK(Events::ended == 1);
    CHECK(Events::destroyed == 8);
    CHECK(scene.touching().empty());
}

TEST_CASE("a shape without overlap is left to Bullet") {
    Scene scene;
    btConvexHullShape& flat = scene.shape<btConvexHullShape>();
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
        flat.addPoint(btVector3(x, y, 0));
    }
    flat.setMargin(0.01);
    scene.add(flat, Vec3(0, 0, 0.5));
    scene.add(scene.shape<btSphereShape>(0.495), Vec3(0.5, 0.5, 0));
    scene.world.performDiscreteCollisionDetection();
    REQUIRE(scene.touching().size() == 1);
    CHECK(scene.touching()[0]->getContactPoint(0).getDistance() == Approx(-0.005).epsilon(1e-3));
}

TEST_CASE("the dispatcher gets its own algorithms back, those registered by others are left") {
    Scene scene;
    const auto stock =
        scene.configuration.getCollisionAlgorithmCreateFunc(BOX_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE);
    CHECK(&scene.overlaps->stock(BOX_SHAPE_PROXYTYPE, BOX_SHAPE_PROXYTYPE) == stock);
    CHECK(OverlapDispatch::of(scene.dispatcher) == scene.overlaps);
    btCollisionAlgorithmCreateFunc own;
    scene.dispatcher.registerCollisionCreateFunc(SPHERE_SHAPE_PROXYTYPE, SPHERE_SHAPE_PROXYTYPE, &own);

    btCollisionObject& lower = scene.add(scene.shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3::Zero());
    btCollisionObject& upper = scene.add(scene.shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, 0, 0.99));
    scene.world.performDiscreteCollisionDetection();
    scene.overlaps.reset();
    // An algorithm that is in use goes on, and a new one is Bullet's.
    scene.world.performDiscreteCollisionDetection();
    CHECK(scene.touching().size() == 1);
    const btCollisionObjectWrapper a(nullptr, upper.getCollisionShape(), &upper, upper.getWorldTransform(),
                                     -1, -1);
    const btCollisionObjectWrapper b(nullptr, lower.getCollisionShape(), &lower, lower.getWorldTransform(),
                                     -1, -1);
    btCollisionAlgorithm* algorithm =
        scene.dispatcher.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    CHECK(dynamic_cast<btBoxBoxCollisionAlgorithm*>(algorithm) != nullptr);
    algorithm->~btCollisionAlgorithm();
    scene.dispatcher.freeCollisionAlgorithm(algorithm);
    scene.overlaps = OverlapDispatch::of(scene.dispatcher);
    CHECK(&scene.overlaps->stock(SPHERE_SHAPE_PROXYTYPE, SPHERE_SHAPE_PROXYTYPE) == &own);
}

TEST_CASE("dispatchers in two threads share nothing") {
    const auto work = [](double& sum) {
        Scene scene;
        Random random(5);
        scene.add_floor();
        for (int i = 0; i < 40; ++i) {
            scene.add(scene.shape<PolyhedronShape>(std::make_shared<const Shape>(random.polyhedron(12, 0.3))),
                      random.vector(-1, 1), random.rotation());
        }
        for (int round = 0; round < 20; ++round) {
            for (std::size_t i = 1; i < scene.objects.size(); ++i) {
                scene.objects[i]->setWorldTransform(to_bullet(Pose{random.vector(-1, 1), random.rotation()}));
            }
            scene.world.performDiscreteCollisionDetection();
            for (const btPersistentManifold* manifold : scene.touching()) {
                for (int i = 0; i < manifold->getNumContacts(); ++i) {
                    sum += manifold->getContactPoint(i).getDistance();
                }
            }
        }
    };
    double alone = 0;
    double one = 0;
    double other = 0;
    work(alone);
    std::thread thread([&] { work(one); });
    work(other);
    thread.join();
    CHECK(alone < 0);
    CHECK(one == alone);
    CHECK(other == alone);
}
