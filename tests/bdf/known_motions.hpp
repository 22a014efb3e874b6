#pragma once

#include <cmath>

#include <tests/bdf/stepping_case.hpp>

namespace scree::test {

// Motions without a jump: of one body, free or in lasting contact with a plane.

constexpr double edge = 0.1;  // of the cubes [m]
constexpr double mass = 2.6;  // [kg]
constexpr double gravity = 9.81;

inline double distance(const BodyState& a, const BodyState& b) {
    return (a.position - b.position).norm() / edge + a.orientation.angularDistance(b.orientation);
}

// Asymmetric, and free.
inline SteppingCase top() {
    SteppingCase scene;
    scene.add_box(Vec3::Ones(), 1, Vec3::Zero());
    scene.system.bodies[0].inertia = Vec3(1, 2, 3);
    scene.system.states[0].angular_momentum = 60 * Vec3(0.3, 2, -0.4);
    return scene;
}

// A cube that presses on a plane with its weight, as deep as that makes it.
inline SteppingCase pressed_cube(double friction, double youngs_modulus = 1e5) {
    SteppingCase scene;
    scene.gravity = gravity;
    scene.add_ground(HalfSpace{});
    scene.add_box(Vec3::Constant(edge), mass / std::pow(edge, 3), Vec3::Zero());
    PairMaterial pair;
    pair.youngs_modulus = youngs_modulus;
    pair.friction = friction;
    const PairConstants& constants = scene.touch(0, 1, pair);
    const double depth = mass * gravity / (constants.elastic * edge * edge);
    scene.system.states[1].position.z() = edge / 2 - depth;
    return scene;
}

// It heaves, and never leaves the plane.
inline SteppingCase floating_cube() {
    SteppingCase scene = pressed_cube(0);
    scene.system.states[1].momentum.z() = 0.05 * mass;
    return scene;
}

// It swings and rocks on the spring of its friction, and never slips.
inline SteppingCase sticking_cube() {
    SteppingCase scene = pressed_cube(10);
    scene.system.states[1].momentum = mass * Vec3(0.03, 0.02, 0);
    return scene;
}

// The plane turns under it, and with it the normal in which the friction is remembered.
inline SteppingCase turned_cube() {
    SteppingCase scene = sticking_cube();
    const Vec3 spin(1.5, 2, 0.7);
    scene.system.states[0].angular_momentum = spin;
    return scene;
}

}  // namespace scree::test
