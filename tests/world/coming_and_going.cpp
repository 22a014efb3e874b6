#include <catch2/catch.hpp>

#include <BulletCollision/CollisionDispatch/btGhostObject.h>

#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

const Contact* contact_of(const BulletScene& scene, const btRigidBody& a, const btRigidBody& b) {
    const int one = scene.world->body_number(a);
    const int other = scene.world->body_number(b);
    for (const Contact& contact : scene.world->system().contacts) {
        if (contact.a.body == std::min(one, other) && contact.b.body == std::max(one, other)) {
            return &contact;
        }
    }
    return nullptr;
}

}  // namespace

TEST_CASE("bodies are numbered in the order in which they were added") {
    BulletScene scene;
    btRigidBody& first = add_cube(scene, 0, 1);
    btRigidBody& second = add_cube(scene, 1, 1);
    btRigidBody& third = add_cube(scene, 2, 1);
    CHECK(scene.world->body_number(first) == 0);
    CHECK(scene.world->body_number(third) == 2);
    CHECK(scene.world->system().states[2].position == Vec3(2, 0, 1));
    step(scene, 1);
    scene.world->removeRigidBody(&second);
    CHECK(scene.world->body_number(second) == -1);
    CHECK(scene.world->system().bodies.size() == 3);  // until the next tick
    step(scene, 1);
    CHECK(scene.world->body_number(first) == 0);
    CHECK(scene.world->body_number(third) == 1);
    CHECK(scene.world->system().bodies.size() == 2);
    scene.world->addRigidBody(&second);
    CHECK(scene.world->body_number(second) == 2);
    step(scene, 1);
}

TEST_CASE("what other contacts remember survives a body's coming and going") {
    BulletScene scene;
    scene.world->setGravity(btVector3(2, 0, -9.81));  // downhill, so that friction has something to hold
    btRigidBody& passing = add_cube(scene, 3, 1);
    btRigidBody& floor = scene.add_floor();
    scene.world->set_material(floor, rock(1e9));
    btRigidBody& lower = add_cube(scene, 0, 0.05);
    btRigidBody& upper = add_cube(scene, 0, 0.15);
    step(scene, 30);
    REQUIRE(contact_of(scene, floor, lower) != nullptr);
    const Vec3 held = contact_of(scene, floor, lower)->history.past[0].force;
    CHECK(held.norm() == Approx(4).epsilon(1e-3));
    const Vec3 before = position_of(lower);

    scene.world->removeRigidBody(&passing);
    add_cube(scene, -3, 1);
    step(scene, 1);
    REQUIRE(contact_of(scene, floor, lower) != nullptr);
    REQUIRE(contact_of(scene, lower, upper) != nullptr);
    CHECK(contact_of(scene, floor, lower)->history.age > 0);
    CHECK((contact_of(scene, floor, lower)->history.past[0].force - held).norm() < 1e-3);
    step(scene, 20);
    CHECK((position_of(lower) - before).norm() < 1e-8);
}

TEST_CASE("a tower falls when a cube is taken out of it, and others may be destroyed") {
    BulletScene scene;
    scene.add_floor();
    btRigidBody& lowest = add_cube(scene, 0, 0.05);
    btRigidBody& middle = add_cube(scene, 0, 0.15);
    btRigidBody& top = add_cube(scene, 0, 0.25);
    step(scene, 10);
    CHECK(scene.world->step_report().contacts == 3);
    scene.destroy(middle);
    step(scene, 40);
    CHECK(position_of(top).z() == Approx(0.15).epsilon(1e-3));
    CHECK(position_of(lowest).z() == Approx(0.05).epsilon(1e-3));
    CHECK(scene.world->step_report().contacts == 2);
    scene.destroy(lowest);
    scene.destroy(top);
    step(scene, 1);
    CHECK(scene.world->step_report().contacts == 0);
    CHECK(scene.world->system().bodies.size() == 1);
}

TEST_CASE("a body's shape may be replaced") {
    BulletScene scene;
    scene.add_floor();
    btRigidBody& cube = add_cube(scene, 0, 0.05);
    step(scene, 10);
    cube.setCollisionShape(&scene.box(Vec3(0.1, 0.1, 0.06)));
    step(scene, 40);
    CHECK(position_of(cube).z() == Approx(0.03).epsilon(1e-3));
}

TEST_CASE("a plain collision object is a fixed body, and a ghost is none") {
    BulletScene scene;
    btCollisionObject slab;
    slab.setCollisionShape(&scene.box(Vec3(1, 1, 0.1)));
    scene.world->addCollisionObject(&slab);
    btPairCachingGhostObject ghost;
    btGhostPairCallback noting;
    scene.broadphase.getOverlappingPairCache()->setInternalGhostPairCallback(&noting);
    ghost.setCollisionShape(&scene.shape<btCapsuleShape>(0.2, 0.2));
    ghost.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
    ghost.setWorldTransform(to_bullet(Pose{Vec3(0, 0, 0.1), Quat::Identity()}));
    scene.world->addCollisionObject(&ghost, btBroadphaseProxy::SensorTrigger, -1);
    btRigidBody& cube = add_cube(scene, 0, 0.11);
    step(scene, 40);
    CHECK(position_of(cube).z() == Approx(0.1).epsilon(1e-3));
    CHECK(scene.world->body_number(slab) == 0);
    CHECK(scene.world->body_number(ghost) == -1);
    CHECK(ghost.getNumOverlappingObjects() == 2);
    scene.world->removeCollisionObject(&slab);
    scene.world->removeCollisionObject(&ghost);
    step(scene, 20);
    CHECK(position_of(cube).z() < 0);
}
