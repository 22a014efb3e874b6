// Cohesion as a contact law with a history of its own: cubes are pressed together under a ceiling until they
// are bonded, then they hang. The topmost bond carries all of them, so as many hold as its strength says, and
// one more pulls it off.

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include <scree/world/dynamics_world.hpp>

#include "sintering_law.hpp"

namespace {

constexpr double edge = 0.1;  // [m]
constexpr double mass = 2.6;  // [kg]
constexpr double gravity = 9.81;
constexpr double tick = 0.01;
constexpr int ticks = 50;

// Gravity goes from one value to another [m/s²], slowly, so that nothing swings.
void run(scree::DynamicsWorld& world, double from, double to) {
    for (int i = 1; i <= ticks; ++i) {
        world.setGravity({0, 0, from + (to - from) * i / ticks});
        world.stepSimulation(tick, 0);
    }
}

// How far the topmost of a number of cubes has come down after they were let hang for half a second [m].
double sunk(int count, double strength) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    scree::DynamicsWorld world(&dispatcher, &pairs, nullptr, &configuration);
    scree::SinteringLaw law;
    law.strength = strength;
    world.set_contact_law(law);

    btStaticPlaneShape plane({0, 0, -1}, 0);
    btBoxShape cube({edge / 2, edge / 2, edge / 2});
    btVector3 inertia;
    cube.calculateLocalInertia(mass, inertia);
    std::vector<std::unique_ptr<btRigidBody>> bodies;
    bodies.push_back(
        std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane)));
    for (int i = 0; i < count; ++i) {
        bodies.push_back(std::make_unique<btRigidBody>(
            btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, &cube, inertia)));
        bodies.back()->setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, 0, -edge * (i + 0.5)}));
    }
    scree::Material clay;
    clay.density = mass / std::pow(edge, 3);
    clay.youngs_modulus = 1e9;
    clay.friction = 0.5;
    for (const auto& body : bodies) {
        world.addRigidBody(body.get());
        world.set_material(*body, clay);
    }
    run(world, 0, gravity);
    const double height = bodies[1]->getWorldTransform().getOrigin().z();
    run(world, gravity, -gravity);
    run(world, -gravity, -gravity);
    const double fallen = height - bodies[1]->getWorldTransform().getOrigin().z();
    for (const auto& body : bodies) {
        world.removeRigidBody(body.get());
    }
    return fallen;
}

}  // namespace

int main() {
    std::printf("strength [Pa]   cubes that the topmost bond carries   strength · face/weight of a cube\n");
    for (const double strength : {4e3, 9e3, 1.5e4}) {
        int held = 0;
        while (held < 20 && sunk(held + 1, strength) < 1e-3 * edge) {
            ++held;
        }
        std::printf("%-15g %-37d %.2f\n", strength, held, strength * edge * edge / (mass * gravity));
    }
}
