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

/// The wall stands until the ball comes, after 1.05 m at 8 m/s; then the floor's friction alone changes the
/// momentum, by at most μ of the weight in a time; and what the ball brought is moving, or accounted for.
inline Rows wall_rows() {
    Simulation simulation(shipped("wall"));
    const std::size_t ball = number_of(simulation, "ball");
    const double brought = mass_of(simulation.bodies()[ball]) * simulation.body_motion(ball).velocity.y();
    double weight = -mass_of(simulation.bodies()[ball]) * gravity;
    for_each_dynamic(simulation, [&](const auto& body, std::size_t) { weight += mass_of(body) * gravity; });
    advance_to(simulation, 0.1199);
    double drift = 0;
    for_each_dynamic(simulation, [&](const SimulationBody& body, std::size_t b) {
        const Vec3 move = simulation.body_motion(b).pose.position - body.start.pose.position;
        drift = b == ball ? drift : std::max(drift, move.head<2>().norm());
    });
    advance_to(simulation, 0.1399);
    const double kept = momentum_of(simulation).y() / brought;
    const double floor = 0.6 * weight * (simulation.time() - 1.05 / 8) / brought;
    const double energy = 0.5 * brought * 8;
    advance_to(simulation, simulation.scene().end_time);
    const double unexplained = std::abs(simulation.report().energy.residual) / energy;
    return {{"wall", "sideways drift of a brick before the hit, m", drift, 0, 1e-7, "none: it stands"},
            {"wall", "momentum across the wall 9 ms after the hit, over the ball's", kept, 1 - floor,
             1 + floor, "momentum, but for at most μ m g t of the floor"},
            {"wall", "energy unexplained over the ball's", unexplained, 0, 0.02, "energy"}};
}

}  // namespace scree::gallery
