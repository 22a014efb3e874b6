#include <catch2/catch.hpp>

#include <cstring>

#include <tests/support/random.hpp>
#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

std::vector<std::shared_ptr<const Shape>> stones(Random& random, int count) {
    std::vector<std::shared_ptr<const Shape>> shapes;
    for (int i = 0; i < count; ++i) {
        shapes.push_back(std::make_shared<const Shape>(random.polyhedron(10, 0.05)));
    }
    return shapes;
}

// Stones that fall on one another in a corner; the bytes of all transforms after every tick.
std::vector<double> heap(btBroadphaseInterface* broadphase) {
    BulletScene scene;
    if (broadphase != nullptr) {
        scene.world =
            std::make_unique<DynamicsWorld>(&scene.dispatcher, broadphase, nullptr, &scene.configuration);
        scene.world->setGravity(btVector3(0, 0, -9.81));
    }
    Random random(12);
    std::vector<btRigidBody*> bodies{&scene.add_floor()};
    for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
        const Vec3 edges = Vec3(0.4, 0.4, 0.6) - 0.38 * side.cwiseAbs();
        bodies.push_back(&scene.add(0, scene.box(edges), 0.12 * side));
    }
    int place = 0;
    for (const auto& stone : stones(random, 12)) {
        const Vec3 corner(place % 2, place / 2 % 2, place / 4);
        const Vec3 position = 0.1 * corner - Vec3(0.05, 0.05, -0.06);
        bodies.push_back(&scene.add(0.5, scene.shape<PolyhedronShape>(stone), position, random.rotation()));
        ++place;
    }
    for (btRigidBody* body : bodies) {
        scene.world->set_material(*body, rock(1e8));
    }
    std::vector<double> record;
    for (int tick = 0; tick < 60; ++tick) {
        scene.world->stepSimulation(0.01, 1, 0.01);
        for (const btRigidBody* body : bodies) {
            for (int i = 0; i < 3; ++i) {
                record.push_back(body->getCenterOfMassPosition()[i]);
                record.push_back(body->getLinearVelocity()[i]);
                record.push_back(body->getAngularVelocity()[i]);
            }
        }
    }
    INFO(scene.world->step_report().message);
    REQUIRE_FALSE(scene.world->step_report().failed);
    CHECK(scene.world->step_report().most_contacts > 8);
    return record;
}

bool same_bytes(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

TEST_CASE("the same scene gives the same bytes, in any broadphase") {
    const std::vector<double> once = heap(nullptr);
    CHECK(same_bytes(once, heap(nullptr)));
    bt32BitAxisSweep3 sweep(btVector3(-9, -9, -9), btVector3(9, 9, 9));
    CHECK(same_bytes(once, heap(&sweep)));
}
