#pragma once

#include <cmath>
#include <numbers>

#include <scree/mesh_io/describe_mesh.hpp>
#include <scree/overlap/overlap.hpp>

#include "row.hpp"

// Many bodies: a hopper, a heap behind a gate, packings, a pile at rest.

namespace scree::gallery {

constexpr double ball_size = 0.02;  // [m], mean diameter of those in the hopper

/// Rate [1/s] at which balls pass the opening of a hopper, from an eighth of them to a half.
inline double discharge(double opening, std::size_t count) {
    SceneDescription scene = shipped("hopper");
    std::get<MeshShape>(scene.shapes.at("hopper")).scale = Vec3::Constant(opening / 0.3);
    scene.fill[0].count = count;
    Simulation simulation(scene);
    const auto passed = [&] {
        std::size_t balls = 0;
        for_each_dynamic(simulation, [&](const SimulationBody& /*body*/, std::size_t b) {
            balls += simulation.body_motion(b).pose.position.z() < 0 ? 1 : 0;
        });
        return balls;
    };
    std::array<std::size_t, 2> balls{};
    std::array<double, 2> times{};
    for (const std::size_t part : {0, 1}) {
        while (balls[part] < count * (3 * part + 1) / 8) {
            advance(simulation);
            balls[part] = passed();
            times[part] = simulation.time();
        }
    }
    return static_cast<double>(balls[1] - balls[0]) / (times[1] - times[0]);
}

/// Beverloo's law of a square opening L: W = 0.74 ρ √g (L − k d)^(5/2), where 0.74 is 4/π times his C = 0.58,
/// ρ that of a bed that is 0.6 solid, and k = 1, as found for balls and openings of a few of them.
inline double beverloo(double opening) {
    const double volume = std::numbers::pi / 6 * std::pow(ball_size, 3);
    return 0.74 * 0.6 / volume * std::sqrt(gravity) * std::pow(opening - ball_size, 2.5);
}

inline Rows hopper_rows() {
    const std::string source = "Beverloo et al. 1961; k = 1: Mankoc et al. 2007";
    const std::array<double, 3> openings{0.07, 0.085, 0.1};
    const std::array<std::size_t, 3> counts{300, 400, 600};
    std::array<double, 3> rates{};
    Rows rows;
    for (std::size_t i = 0; i < 3; ++i) {
        rates[i] = discharge(openings[i], counts[i]);
        char what[100];
        std::snprintf(what, sizeof what, "opening of %.2f balls: rate over 0.74 ρ √g (L − d)^(5/2)",
                      openings[i] / ball_size);
        rows.push_back(near("hopper", what, rates[i] / beverloo(openings[i]), 1, 0.25, source));
    }
    const double growth = std::log((openings[2] - ball_size) / (openings[0] - ball_size));
    rows.push_back(near("hopper", "power of L − d by which the rate grows",
                        std::log(rates[2] / rates[0]) / growth, 2.5, 0.1, source));
    return rows;
}

/// The angle [degrees] of the wedge between floor and wall that has the heap's mass centre.
inline double angle_of_repose(double friction) {
    SceneDescription scene = shipped("repose");
    scene.materials.at("rock").friction = friction;
    Simulation simulation(scene);
    advance_to(simulation, scene.end_time);
    Vec3 centre = Vec3::Zero();
    for_each_dynamic(simulation, [&](const SimulationBody& body, std::size_t b) {
        centre += mass_of(body) * simulation.body_motion(b).pose.position;
    });
    return std::atan2(centre.z(), centre.x()) * 180 / std::numbers::pi;
}

inline Rows repose_rows() {
    Rows rows;
    double last = 5;
    for (const char* friction : {"0.1", "0.3", "0.9"}) {
        const double angle = angle_of_repose(std::stod(friction));
        rows.push_back({"repose", std::string("angle at μ = ") + friction + ", degrees", angle, last, 45,
                        "rises with friction: Zhou et al. 2001, Phys. Rev. E 64, 021301"});
        last = angle;
    }
    return rows;
}

/// The share of a box well inside that the bodies fill.
inline double solid_fraction(const Simulation& simulation) {
    double height = 0;
    double count = 0;
    for_each_dynamic(simulation, [&](const SimulationBody& /*body*/, std::size_t b) {
        height += simulation.body_motion(b).pose.position.z();
        ++count;
    });
    const double top = 2 * height / count - 0.04;
    const double bottom = 0.02;
    const Vec3 edges(0.12, 0.12, top - bottom);
    const Shape probe = make_box(edges);
    const Pose place{Vec3(0, 0, (top + bottom) / 2), Quat::Identity()};
    OverlapWorkspace workspace;
    double filled = 0;
    for_each_dynamic(simulation, [&](const SimulationBody& body, std::size_t b) {
        ContactGeometry geometry;
        if (overlap(probe, place, *body.solid.shape, simulation.body_motion(b).pose, Detail::force, false,
                    workspace, geometry)) {
            filled += geometry.volume;
        }
    });
    return filled / edges.prod();
}

/// Of one of the Platonic solids, poured once.
inline double pour(const std::string& solid, std::uint64_t seed) {
    SceneDescription scene = shipped("packing");
    auto& die = std::get<MeshShape>(scene.shapes.at("die"));
    const std::filesystem::path meshes = scene.file.parent_path() / die.file.parent_path();
    const double volume = describe_mesh(meshes / die.file.filename()).mass.volume * die.scale.prod();
    die.file = die.file.parent_path() / (solid + ".obj");
    die.scale.setConstant(std::cbrt(volume / describe_mesh(meshes / (solid + ".obj")).mass.volume));
    scene.fill[0].seed = seed;
    Simulation simulation(scene);
    advance_to(simulation, scene.end_time);
    return solid_fraction(simulation);
}

/// The mean of three pours, which differ by some hundredths.
inline double packing(const std::string& solid) {
    return (pour(solid, 1) + pour(solid, 2) + pour(solid, 3)) / 3;
}

/// Loose to dense, give or take 0.02 for the mean of three pours.
inline Rows packing_rows() {
    const std::vector<std::pair<const char*, std::array<double, 2>>> known = {{"tetrahedron", {0.51, 0.64}},
                                                                              {"cube", {0.54, 0.67}},
                                                                              {"octahedron", {0.52, 0.64}},
                                                                              {"dodecahedron", {0.51, 0.63}},
                                                                              {"icosahedron", {0.50, 0.59}}};
    Rows rows;
    for (const auto& [solid, spread] : known) {
        rows.push_back({"packing", std::string("solid fraction, ") + solid, packing(solid), spread[0] - 0.02,
                        spread[1] + 0.02,
                        "loose to dense ± 0.02: Baker & Kudrolli 2010, Phys. Rev. E 82, 061304"});
    }
    return rows;
}

inline Rows pile_rows() {
    Simulation simulation(shipped("pile"));
    advance_to(simulation, simulation.scene().end_time);
    double fastest = 0;
    for_each_dynamic(simulation, [&](const SimulationBody& /*body*/, std::size_t b) {
        fastest = std::max(fastest, simulation.body_motion(b).velocity.norm());
    });
    return {{"pile", "fastest stone at the end, m/s", fastest, 0, 1e-6, "none: it is at rest"}};
}

}  // namespace scree::gallery
