// Through Bullet's own importer, which puts shapes, masses, places and surfaces back, but no velocities:
// those are looked up in the file.
#include <catch2/catch.hpp>

#include <BulletFileLoader/btBulletFile.h>
#include <BulletWorldImporter/btBulletWorldImporter.h>
#include <LinearMath/btSerializer.h>

#include <map>
#include <string>

#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// A world of every kind of shape that moves, on a plane.
template <class World>
std::vector<btRigidBody*> fill(SceneOf<World>& scene) {
    btCompoundShape& pair = scene.template shape<btCompoundShape>();
    auto& half = scene.template shape<btSphereShape>(0.2);
    pair.addChildShape(to_bullet(Pose{Vec3(-0.2, 0, 0), Quat::Identity()}), &half);
    pair.addChildShape(to_bullet(Pose{Vec3(0.2, 0, 0), Quat::Identity()}), &half);
    std::vector<btRigidBody*> bodies{
        &scene.add_floor(),
        &add_box(scene, Vec3(0, 0, 0.2), 0.2),
        &scene.add(2, scene.template shape<btSphereShape>(0.3), Vec3(2, 0, 0.3)),
        &scene.add(3, scene.template shape<btCylinderShapeZ>(btVector3(0.2, 0.2, 0.1)), Vec3(4, 0, 0.1)),
        &scene.add(4, scene.template shape<btCapsuleShapeX>(0.1, 0.4), Vec3(6, 0, 0.1)),
        &scene.add(5, scene.template shape<btConeShapeZ>(0.3, 0.2), Vec3(8, 0, 0.1)),
        &scene.add(6, scene.box(Vec3(0.4, 0.4, 0.2)), Vec3(10, 0, 0.1)),
        &scene.add(7, pair, Vec3(12, 0, 0.2))};
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i]->setFriction(0.3 + 0.1 * static_cast<double>(i));
        bodies[i]->setRestitution(0.05 * static_cast<double>(i));
        bodies[i]->setDamping(0.01, 0.02);
    }
    return bodies;
}

template <class World>
std::string bytes_of(World& world) {
    btDefaultSerializer serializer;
    world.serialize(&serializer);
    return {reinterpret_cast<const char*>(serializer.getBufferPointer()),
            static_cast<std::size_t>(serializer.getCurrentBufferSize())};
}

// What the file has of each body, by its mass.
std::map<double, btRigidBodyDoubleData> bodies_in(std::string bytes) {
    bParse::btBulletFile file(bytes.data(), static_cast<int>(bytes.size()));
    REQUIRE(file.ok());
    file.parse(0);
    std::map<double, btRigidBodyDoubleData> bodies;
    for (int i = 0; i < file.m_rigidBodies.size(); ++i) {
        const auto& data = *reinterpret_cast<const btRigidBodyDoubleData*>(file.m_rigidBodies[i]);
        bodies[data.m_inverseMass > 0 ? 1 / data.m_inverseMass : 0] = data;
    }
    return bodies;
}

bool same(const btVector3& a, const btVector3DoubleData& b) {
    return a.x() == b.m_floats[0] && a.y() == b.m_floats[1] && a.z() == b.m_floats[2];
}

}  // namespace

TEMPLATE_TEST_CASE("both worlds: a world is serialised", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    scene.world->setGravity(btVector3(0, 0, -3.7));
    const std::vector<btRigidBody*> bodies = fill(scene);
    bodies[2]->setLinearVelocity(btVector3(0, 1, 0));
    step(scene, 10);
    std::string bytes = bytes_of(*scene.world);
    CHECK(bytes.substr(0, 7) == "BULLETd");

    const auto written = bodies_in(bytes);
    REQUIRE(written.size() == bodies.size());
    SceneOf<TestType> other;
    btBulletWorldImporter importer(other.world.get());
    REQUIRE(importer.loadFileFromMemory(bytes.data(), static_cast<int>(bytes.size())));
    CHECK(other.world->getGravity().z() == -3.7);
    REQUIRE(other.world->getNumCollisionObjects() == static_cast<int>(bodies.size()));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const btRigidBody& one = *bodies[i];
        const btRigidBody& read =
            *btRigidBody::upcast(other.world->getCollisionObjectArray()[static_cast<int>(i)]);
        INFO(one.getCollisionShape()->getName());
        CHECK(read.getCollisionShape()->getShapeType() == one.getCollisionShape()->getShapeType());
        CHECK(read.getMass() == Approx(one.getMass()).epsilon(1e-15));
        CHECK((position_of(read) - position_of(one)).norm() < 1e-15);
        CHECK(read.getFriction() == one.getFriction());
        CHECK(read.getRestitution() == one.getRestitution());
        const btRigidBodyDoubleData& data = written.at(one.getMass() > 0 ? 1 / one.getInvMass() : 0);
        CHECK(same(one.getLinearVelocity(), data.m_linearVelocity));
        CHECK(same(one.getAngularVelocity(), data.m_angularVelocity));
        CHECK(data.m_linearDamping == one.getLinearDamping());
    }
    // What lay on the plane lies there still; what Bullet has put its margin under may sink by some of that.
    run(other, 0.5);
    for (int i = 1; i < other.world->getNumCollisionObjects(); ++i) {
        const btRigidBody& read = *btRigidBody::upcast(other.world->getCollisionObjectArray()[i]);
        INFO(read.getCollisionShape()->getName());
        CHECK(position_of(read).z() ==
              Approx(position_of(*bodies[static_cast<std::size_t>(i)]).z()).margin(0.02));
    }
    importer.deleteAllData();
}
