#include <catch2/catch.hpp>

#include <BulletCollision/CollisionDispatch/btGhostObject.h>

#include <cmath>
#include <cstring>

#include <tests/support/random.hpp>
#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

std::vector<btPersistentManifold*> touching(BulletScene& scene) {
    std::vector<btPersistentManifold*> found;
    for (int i = 0; i < scene.dispatcher.getNumManifolds(); ++i) {
        if (scene.dispatcher.getManifoldByIndexInternal(i)->getNumContacts() > 0) {
            found.push_back(scene.dispatcher.getManifoldByIndexInternal(i));
        }
    }
    return found;
}

struct Drawer : btIDebugDraw {
    int contacts = 0;
    int mode = DBG_DrawContactPoints;
    void drawLine(const btVector3& /*a*/, const btVector3& /*b*/, const btVector3& /*colour*/) override {}
    void drawContactPoint(const btVector3& /*point*/, const btVector3& /*normal*/, btScalar /*distance*/,
                          int /*age*/, const btVector3& /*colour*/) override {
        ++contacts;
    }
    void reportErrorWarning(const char* /*text*/) override {}
    void draw3dText(const btVector3& /*at*/, const char* /*text*/) override {}
    void setDebugMode(int wanted) override { mode = wanted; }
    int getDebugMode() const override { return mode; }
};

// A few stones that come to rest; where they are after each tick.
std::vector<double> stones(bool manifolds, StepReport& report, int& made) {
    BulletScene scene;
    scene.world->set_manifolds(manifolds);
    Random random(21);
    std::vector<btRigidBody*> bodies{&scene.add_floor()};
    for (int i = 0; i < 8; ++i) {
        const auto shape = std::make_shared<const Shape>(random.polyhedron(10, 0.05));
        bodies.push_back(&scene.add(0.5, scene.shape<PolyhedronShape>(shape),
                                    Vec3(0.02 * (i % 2), 0, 0.06 + 0.09 * i), random.rotation()));
    }
    for (btRigidBody* body : bodies) {
        scene.world->set_material(*body, rock(1e8));
    }
    std::vector<double> record;
    for (int tick = 0; tick < 40; ++tick) {
        step(scene, 1);
        for (const btRigidBody* body : bodies) {
            for (int i = 0; i < 3; ++i) {
                record.push_back(body->getCenterOfMassPosition()[i]);
            }
        }
    }
    report = scene.world->step_report();
    made = scene.dispatcher.getNumManifolds();
    return record;
}

}  // namespace

TEST_CASE("after a tick the manifolds hold the contacts, with the impulses of their forces") {
    BulletScene scene;
    const double slope = 0.2;
    scene.world->setGravity(btVector3(9.81 * std::sin(slope), 0, -9.81 * std::cos(slope)));
    btRigidBody& floor = scene.add_floor();
    btRigidBody& box = scene.add(2, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.05));
    scene.world->set_material(floor, rock(1e9));
    scene.world->set_material(box, rock(1e9));
    step(scene, 50);
    const auto manifolds = touching(scene);
    REQUIRE(manifolds.size() == 1);
    REQUIRE(manifolds[0]->getNumContacts() == 4);
    const double sign = manifolds[0]->getBody0() == &box ? 1 : -1;
    double normal = 0;
    Vec3 friction = Vec3::Zero();
    for (int i = 0; i < 4; ++i) {
        const btManifoldPoint& point = manifolds[0]->getContactPoint(i);
        CHECK(point.getDistance() < 0);
        CHECK(point.getDistance() > -1.1 * scene.world->contact_results()[0].depth);
        normal += point.getAppliedImpulse();
        friction += sign * point.m_appliedImpulseLateral1 * to_eigen(point.m_lateralFrictionDir1);
    }
    CHECK(normal == Approx(2 * 9.81 * std::cos(slope) * 0.01).epsilon(1e-3));
    CHECK((friction - Vec3(-2 * 9.81 * std::sin(slope) * 0.01, 0, 0)).norm() < 1e-3 * normal);

    Drawer drawer;
    scene.world->setDebugDrawer(&drawer);
    scene.world->debugDrawWorld();
    CHECK(drawer.contacts == 4);
    scene.world->setDebugDrawer(nullptr);
}

TEST_CASE("manifolds change nothing in what bodies do, and cost nothing when they are off") {
    StepReport with, without;
    int made = 0;
    const std::vector<double> one = stones(true, with, made);
    CHECK(made > 4);
    CHECK(with.manifold_pairs > 100);
    const std::vector<double> other = stones(false, without, made);
    CHECK(made == 0);
    CHECK(without.manifold_pairs == 0);
    CHECK(without.all_steps.contact_evaluations == with.all_steps.contact_evaluations);
    REQUIRE(one.size() == other.size());
    CHECK(std::memcmp(one.data(), other.data(), one.size() * sizeof(double)) == 0);
}

TEST_CASE("switched off while running, manifolds and algorithms go, and come back") {
    BulletScene scene;
    scene.add_floor();
    scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.05));
    step(scene, 5);
    CHECK(touching(scene).size() == 1);
    scene.world->set_manifolds(false);
    CHECK(scene.dispatcher.getNumManifolds() == 0);
    step(scene, 2);
    const btBroadphasePairArray& pairs = scene.world->getPairCache()->getOverlappingPairArray();
    REQUIRE(pairs.size() == 1);
    CHECK(pairs[0].m_algorithm == nullptr);
    scene.world->set_manifolds(true);
    step(scene, 1);
    CHECK(touching(scene).size() == 1);
}

TEST_CASE("a manifold goes with its body, and follows a shape that is replaced") {
    BulletScene scene;
    scene.add_floor();
    btRigidBody& lower = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.05));
    btRigidBody& upper = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.15));
    step(scene, 5);
    CHECK(touching(scene).size() == 2);
    lower.setCollisionShape(&scene.box(Vec3(0.06, 0.06, 0.1)));
    step(scene, 1);
    for (const btPersistentManifold* manifold : touching(scene)) {
        REQUIRE(manifold->getNumContacts() == 4);
        for (int i = 0; i < 4; ++i) {
            CHECK(std::abs(manifold->getContactPoint(i).getPositionWorldOnB().x()) ==
                  Approx(0.03).epsilon(1e-3));
        }
    }
    scene.destroy(upper);
    CHECK(touching(scene).size() == 1);
    step(scene, 1);
    CHECK(touching(scene).size() == 1);
}

TEST_CASE("a ghost has manifolds with what passes through it, and no forces") {
    BulletScene scene;
    btPairCachingGhostObject ghost;
    btGhostPairCallback noting;
    scene.broadphase.getOverlappingPairCache()->setInternalGhostPairCallback(&noting);
    ghost.setCollisionShape(&scene.shape<btSphereShape>(0.3));
    ghost.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
    scene.world->addCollisionObject(&ghost, btBroadphaseProxy::SensorTrigger, -1);
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 1));
    int seen = 0;
    for (int i = 0; i < 60; ++i) {
        step(scene, 1);
        const double height = position_of(box).z();
        const bool inside = std::abs(height) < 0.25;
        const bool outside = std::abs(height) > 0.35;
        seen += static_cast<int>(touching(scene).size());
        CHECK((!inside || touching(scene).size() == 1));
        CHECK((!outside || touching(scene).empty()));
    }
    CHECK(seen > 5);
    CHECK(box.getLinearVelocity().z() == Approx(-9.81 * 0.6).epsilon(1e-6));
    CHECK(scene.world->step_report().most_contacts == 0);
    scene.world->removeCollisionObject(&ghost);
}

TEST_CASE("two bodies of several parts have a manifold a pair of parts, each with its own impulse") {
    BulletScene scene;
    btRigidBody& floor = scene.add_floor();
    btCompoundShape& table = scene.shape<btCompoundShape>();
    table.addChildShape(to_bullet(Pose{Vec3(0.2, 0, 0), Quat::Identity()}), &scene.box(Vec3::Constant(0.1)));
    table.addChildShape(to_bullet(Pose{Vec3(-0.1, 0, 0), Quat::Identity()}), &scene.box(Vec3::Constant(0.1)));
    btRigidBody& body = scene.add(3, table, Vec3(0, 0, 0.05));
    scene.world->set_material(floor, rock(1e9));
    scene.world->set_material(body, rock(1e9));
    step(scene, 50);
    const auto manifolds = touching(scene);
    REQUIRE(manifolds.size() == 2);
    for (const btPersistentManifold* manifold : manifolds) {
        double sum = 0;
        for (int i = 0; i < manifold->getNumContacts(); ++i) {
            sum += manifold->getContactPoint(i).getAppliedImpulse();
        }
        const bool right = manifold->getContactPoint(0).getPositionWorldOnB().x() > 0.1;
        // The body leans a little to its heavier side, and so does each part's force.
        CHECK(sum == Approx(3 * 9.81 * 0.01 * (right ? 1.0 / 3 : 2.0 / 3)).epsilon(0.03));
    }
}
