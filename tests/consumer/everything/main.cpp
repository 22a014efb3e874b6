#include <cstdio>

#include <scree/mesh_io/load_mesh.hpp>
#include <scree/output/output_folder.hpp>
#include <scree/scenes/find_scene.hpp>
#include <scree/version.hpp>
#include <scree/world/dynamics_world.hpp>

// Uses something of every component that has a library of its own.
int main() {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    scree::DynamicsWorld world(&dispatcher, &pairs, nullptr, &configuration);
    const int ticks = world.stepSimulation(0.1, 10, 0.01);
    std::printf("scree %d.%d.%d let %d ticks pass\n", scree::version_major, scree::version_minor,
                scree::version_patch, ticks);
    return ticks == 10 ? 0 : 1;
}
