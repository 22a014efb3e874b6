#include <cmath>
#include <cstdio>

#include <btBulletDynamicsCommon.h>
#include <scree/world/dynamics_world.hpp>

// A Bullet program outside the project: a block that a slope of 30 degrees holds, as μ = 0.81 says.
int main() {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    scree::DynamicsWorld world(&dispatcher, &pairs, nullptr, &configuration);
    world.setGravity({4.9, 0, -8.5});

    btStaticPlaneShape plane({0, 0, 1}, 0);
    btRigidBody ground(0, nullptr, &plane);
    btBoxShape box({0.05, 0.05, 0.05});
    btRigidBody block(2.6, nullptr, &box, {0.0043, 0.0043, 0.0043});
    block.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, 0, 0.05}));
    for (btRigidBody* body : {&ground, &block}) {
        body->setFriction(0.9);
        world.addRigidBody(body);
    }
    for (int i = 0; i < 240; ++i) {
        world.stepSimulation(1.0 / 240, 0);
    }
    const double moved = block.getWorldTransform().getOrigin().x();
    std::printf("moved by %g m\n", moved);
    for (btRigidBody* body : {&block, &ground}) {
        world.removeRigidBody(body);
    }
    return std::abs(moved) < 1e-4 ? 0 : 1;
}
