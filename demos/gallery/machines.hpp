#pragma once

#include <cmath>
#include <numbers>

#include "row.hpp"

// Bodies that move as prescribed and what they do to others: a conveyor, a drum, a vibrating plate; and the
// block on a slope.

namespace scree::gallery {

inline Rows incline_rows() {
    Simulation simulation(shipped("incline"));
    advance_to(simulation, 1);
    const double before = simulation.body_motion(1).velocity.x();
    advance_to(simulation, 2);
    const double acceleration = simulation.body_motion(1).velocity.x() - before;
    const double slope = 27 * std::numbers::pi / 180;
    return {near("incline", "acceleration at 27°, m/s²", acceleration,
                 gravity * (std::sin(slope) - 0.5 * std::cos(slope)), 1e-4, "g (sin θ − μ cos θ): Coulomb")};
}

/// What a lane of the conveyor lags behind its belt, and what the belt did for all of them.
inline Rows conveyor_rows() {
    constexpr double belt = 0.8;
    constexpr double end = 0.7;  // [s], when all go with the belt and none has left it
    Simulation simulation(shipped("conveyor"));
    advance_to(simulation, end - 1e-9);
    std::map<std::string, double> lag;
    double mass = 0;
    for_each_dynamic(simulation, [&](const SimulationBody& body, std::size_t b) {
        const double way = simulation.file_motion(b).pose.position.x() - body.start.pose.position.x();
        lag[body.material] += (belt * simulation.time() - way) / 4;
        mass += mass_of(body);
    });
    Rows rows;
    for (const auto& [material, mean] : lag) {
        const double friction = simulation.scene().materials.at(material).friction;
        rows.push_back(near("conveyor", "lag of the stones of " + material + ", m", mean,
                            belt * belt / (2 * friction * gravity), 0.01, "u²/(2 μ g): Coulomb"));
    }
    rows.push_back(near("conveyor", "work of the belt over m u²",
                        simulation.report().energy.work_applied / (mass * belt * belt), 1, 0.01,
                        "momentum: ½ m u² kept, ½ m u² lost"));
    return rows;
}

/// The drum's work over a second and a half against the moment of the stones' weight about its axis:
/// ω (ΔL + ∫ M g (−x) dt), L their angular momentum.
inline Rows drum_rows() {
    Simulation simulation(shipped("drum"));
    const double spin = 1.5;
    double weight_arm = 0;  // [N m]
    double momentum = 0;    // [kg m²/s]
    const auto look = [&] {
        weight_arm = momentum = 0;
        for_each_dynamic(simulation, [&](const SimulationBody& body, std::size_t b) {
            const FrameMotion motion = simulation.body_motion(b);
            weight_arm -= mass_of(body) * gravity * motion.pose.position.x();
            momentum += mass_of(body) * motion.pose.position.cross(motion.velocity).y();
        });
    };
    advance_to(simulation, 1.4999);
    look();
    const double work = simulation.report().energy.work_applied;
    const double start = momentum;
    double moment = 0;  // [N m s]
    while (simulation.tick() < simulation.times().last()) {
        const double last = weight_arm;
        advance(simulation);
        look();
        moment += 0.5 * (last + weight_arm) * simulation.scene().output.every;
    }
    return {near("drum", "work of the drum over the moment of what it lifts, times its turn",
                 (simulation.report().energy.work_applied - work) / (spin * (momentum - start + moment)), 1,
                 0.03, "balance of angular momentum")};
}

/// The share of its period that a soft block spends in the air over a plate of so many g.
inline double block_flight(double strength) {
    if (strength <= 1) {
        return 0;
    }
    const double begin = std::asin(1 / strength);
    // In units of g/ω²: the block's height over the plate's, a phase after it left.
    const auto height = [&](double phase) {
        return 1 + strength * std::cos(begin) * phase - 0.5 * phase * phase -
               strength * std::sin(begin + phase);
    };
    double phase = 0.1;
    while (height(phase) > 0) {
        phase += 1e-4;
    }
    return phase / (2 * std::numbers::pi);
}

/// The plate with the strength of its shaking, in g.
inline SceneDescription shaken(double strength) {
    SceneDescription scene = shipped("vibrating_plate");
    for (BodyDescription& body : scene.bodies) {
        if (auto* motion = std::get_if<PrescribedMotion>(&body.motion)) {
            motion->amplitude = strength * gravity / std::pow(2 * std::numbers::pi * motion->frequency, 2);
        }
    }
    return scene;
}

/// A soft flat block in place of the stones: with ζ = 10 it does not bounce. Its flight of a tenth of a
/// millimetre wants tighter tolerances.
inline SceneDescription block_on_plate(double strength) {
    SceneDescription scene = shaken(strength);
    scene.fill.clear();
    scene.stepping.rtol = 1e-5;
    scene.output.every /= 10;
    scene.shapes["block"] = BoxShape{Vec3(0.05, 0.05, 0.02)};
    scene.materials["soft"] = scene.materials.at("rock");
    scene.materials["soft"].normal_damping = scene.materials["steel"].normal_damping = 20;
    BodyDescription block;
    block.shape = "block";
    block.material = "soft";
    block.position.z() = 0.01;
    scene.bodies.push_back(block);
    return scene;
}

/// The share of time in which the plate bears less than a share of the weight of what lies on it.
inline double share_in_flight(const SceneDescription& scene, double least) {
    Simulation simulation(scene);
    const auto plate = static_cast<int>(number_of(simulation, "plate"));
    double weight = 0;
    for_each_dynamic(simulation, [&](const auto& body, std::size_t) { weight += mass_of(body) * gravity; });
    advance_to(simulation, 0.5 - 1e-9);
    int flying = 0;
    int looks = 0;
    while (simulation.tick() < simulation.times().last()) {
        advance(simulation);
        double force = 0;
        for (std::size_t i = 0; i < simulation.contacts().size(); ++i) {
            const Contact& contact = simulation.contacts()[i];
            if (contact.a.body == plate || contact.b.body == plate) {
                force += std::abs(simulation.contact_results()[i].law.force.z());
            }
        }
        flying += force < least * weight ? 1 : 0;
        ++looks;
    }
    return static_cast<double>(flying) / looks;
}

/// A block follows its closed form; a bed of loose stones, which lands and leaves bit by bit, only roughly.
inline Rows vibrating_plate_rows() {
    const std::string source = "block that does not bounce: Mehta & Luck 1990";
    Rows rows;
    const auto add = [&](const char* what, double strength, double measured, double margin) {
        char text[100];
        std::snprintf(text, sizeof text, "%s at A ω² = %.1f g: share of time in flight", what, strength);
        const double expected = block_flight(strength);
        rows.push_back(
            {"vibrating_plate", text, measured, std::max(0.0, expected - margin), expected + margin, source});
    };
    for (const double strength : {0.9, 1.2, 1.5, 2.0}) {
        add("block", strength, share_in_flight(block_on_plate(strength), 1e-3), 0.01);
    }
    add("bed of 40 stones", 1.5, share_in_flight(shaken(1.5), 0.1), 0.1);
    return rows;
}

}  // namespace scree::gallery
