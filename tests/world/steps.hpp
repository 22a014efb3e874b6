#pragma once

#include <catch2/catch.hpp>

#include <cmath>
#include <type_traits>

#include <tests/world/bullet_scene.hpp>

namespace scree::test {

/// Ticks [s], each a call of its own; none of them may fail.
template <class World>
void step(SceneOf<World>& scene, int ticks, double tick = 0.01) {
    for (int i = 0; i < ticks; ++i) {
        scene.world->stepSimulation(tick, 1, tick);
    }
    if constexpr (std::is_same_v<World, DynamicsWorld>) {
        INFO(scene.world->step_report().message);
        REQUIRE_FALSE(scene.world->step_report().failed);
    }
}

/// The same for a time [s].
template <class World>
void run(SceneOf<World>& scene, double time, double tick = 1.0 / 240) {
    step(scene, static_cast<int>(std::lround(time / tick)), tick);
}

/// A fixed box with its upper face at z = 0.
template <class World>
btRigidBody& add_ground(SceneOf<World>& scene) {
    return scene.add(0, scene.template shape<btBoxShape>(btVector3(20, 20, 0.5)), Vec3(0, 0, -0.5));
}

/// A box of 1 kg, of half edges [m].
template <class World>
btRigidBody& add_box(SceneOf<World>& scene, const Vec3& at, double half = 0.5) {
    return scene.add(1, scene.template shape<btBoxShape>(btVector3(half, half, half)), at);
}

/// A cube of 0.1 m and 1 kg above the x axis, of rock with the given modulus [Pa].
inline btRigidBody& add_cube(BulletScene& scene, double x, double z, double youngs_modulus = 1e9) {
    btRigidBody& cube = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(x, 0, z));
    scene.world->set_material(cube, rock(youngs_modulus));
    return cube;
}

}  // namespace scree::test
