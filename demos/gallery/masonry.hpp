#pragma once

#include <cmath>
#include <numbers>

#include "row.hpp"

// What stands or falls by its own weight: an arch, a tower, a wall that is hit.

namespace scree::gallery {

/// How far the stone that moves farthest goes, over the arch's radius of 1 m; an arch that falls is left to
/// fall half a radius.
inline double arch_move(const std::string& mesh, const std::string& modulus) {
    Simulation simulation(shipped("arch", {"shapes.voussoir.mesh=\"../../meshes/" + mesh + ".obj\"",
                                           "materials.stone.youngs_modulus=" + modulus}));
    double move = 0;
    while (simulation.tick() < simulation.times().last() && move < 0.5) {
        advance(simulation);
        move = farthest_move(simulation);
    }
    return move;
}

/// Of rigid stones with radial joints the limit is t/R = 0.1075; stones of 10¹² Pa are as good as rigid.
inline Rows arch_rows() {
    const std::string limit = "limit t/R = 0.1075: Milankovitch 1907";
    constexpr double stands = 1e-3;
    constexpr double falls = 0.5;
    return {
        {"arch", "t/R 0.120: farthest move over R", arch_move("voussoir_120", "5e10"), 0, stands, limit},
        {"arch", "t/R 0.100: the same", arch_move("voussoir_100", "5e10"), falls, infinity, limit},
        {"arch", "t/R 0.108, stones of 1e12 Pa", arch_move("voussoir_108", "1e12"), 0, stands, limit},
        {"arch", "t/R 0.107, stones of 1e12 Pa", arch_move("voussoir_107", "1e12"), falls, infinity, limit}};
}

/// How far [edges] a cube of the tower goes sideways at a share of the stiffness at which it buckles.
inline double tower_drift(double share) {
    constexpr double edge = 0.1;
    const double limit = std::pow(10.5, 3) * edge * 2600 * gravity / 0.526;
    SceneDescription scene = shipped("tower");
    scene.materials.at("rubber").youngs_modulus = share * limit;
    Simulation simulation(scene);
    double drift = 0;
    while (simulation.tick() < simulation.times().last() && drift < 1) {
        advance(simulation);
        for_each_dynamic(simulation, [&](const SimulationBody& /*body*/, std::size_t b) {
            drift = std::max(drift, simulation.body_motion(b).pose.position.head<2>().norm() / edge);
        });
    }
    return drift;
}

inline Rows tower_rows() {
    const std::string limit = "self-buckling at Y = (n + ½)³ a ρ g/0.526: Greenhill 1881 for elastic joints";
    return {{"tower", "Y 1.25 of the limit: farthest drift, edges", tower_drift(1.25), 0, 0.1, limit},
            {"tower", "Y 0.8 of the limit: the same", tower_drift(0.8), 1, infinity, limit}};
}

/// Momentum [kg m/s] of all that moves.
inline Vec3 momentum_of(const Simulation& simulation) {
    Vec3 momentum = Vec3::Zero();
    for_each_dynamic(simulation, [&](const SimulationBody& body, std::size_t b) {
        momentum += mass_of(body) * simulation.body_motion(b).velocity;
    });
    return momentum;
}

/// What all that moves has of momentum across the wall, over what the ball brought, 9 ms after it has come.
inline double momentum_after_hit(const std::string& friction) {
    Simulation simulation(shipped("wall", {"materials.ground.friction=" + friction}));
    const double brought = momentum_of(simulation).y();
    advance_to(simulation, 0.1399);
    return momentum_of(simulation).y() / brought;
}

/// Weight [N] of all that moves.
inline double weight_of(const Simulation& simulation) {
    double weight = 0;
    for_each_dynamic(simulation, [&](const auto& body, std::size_t) { weight += mass_of(body) * gravity; });
    return weight;
}

/// The wall stands until the ball comes, after 1.05 m at 8 m/s; then the floor's friction alone changes the
/// momentum, by at most μ of the floor's upward impulse; and what the ball brought moves, or is accounted
/// for.
inline Rows wall_rows() {
    Simulation simulation(shipped("wall"));
    const std::size_t ball = number_of(simulation, "ball");
    advance_to(simulation, 0.1199);
    double drift = 0;
    for_each_dynamic(simulation, [&](const SimulationBody& body, std::size_t b) {
        const Vec3 move = simulation.body_motion(b).pose.position - body.start.pose.position;
        drift = b == ball ? drift : std::max(drift, move.head<2>().norm());
    });
    const Vec3 before = momentum_of(simulation);
    const double start = simulation.time();
    advance_to(simulation, 0.1399);
    const Vec3 change = momentum_of(simulation) - before;
    const double upward = change.z() + weight_of(simulation) * (simulation.time() - start);
    advance_to(simulation, simulation.scene().end_time);
    const double energy = 0.5 * before.y() * 8;
    const double unexplained = std::abs(simulation.report().energy.residual) / energy;
    return {{"wall", "sideways drift of a brick before the hit, m", drift, 0, 1e-7, "none: it stands"},
            near("wall", "momentum after the hit over the ball's, on a smooth floor", momentum_after_hit("0"),
                 1, 1e-6, "momentum"),
            {"wall", "friction's impulse over μ times the floor's, rough floor",
             change.head<2>().norm() / (0.6 * upward), 0, 1, "Coulomb"},
            {"wall", "energy unexplained over the ball's", unexplained, 0, 0.02, "energy"}};
}

}  // namespace scree::gallery
