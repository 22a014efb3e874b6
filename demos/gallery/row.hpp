#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <scree/scenes/find_scene.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

namespace scree::gallery {

/// A result of a scene beside what literature or a closed form says of it.
struct Row {
    std::string scene, what;
    double measured = 0;
    double low = 0, high = 0;  ///< within which it must lie
    std::string source;        ///< of the bounds

    [[nodiscard]] bool holds() const { return low <= measured && measured <= high; }
};
using Rows = std::vector<Row>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double gravity = 9.81;  // [m/s²], that of the scenes

inline Row near(const std::string& scene, const std::string& what, double measured, double expected,
                double tolerance, const std::string& source) {
    const double margin = tolerance * std::abs(expected);
    return {scene, what, measured, expected - margin, expected + margin, source};
}

inline SceneDescription shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
    return read_scene(find_scene(name), settings);
}

/// On to the next output time. Throws std::runtime_error when the world cannot.
inline void advance(Simulation& simulation) {
    if (!simulation.advance()) {
        throw std::runtime_error(simulation.report().message);
    }
}

inline void advance_to(Simulation& simulation, double time) {
    while (simulation.tick() < simulation.times().last() && simulation.time() < time) {
        advance(simulation);
    }
}

/// Calls use(body, number) for each body that forces move.
template <class Use>
void for_each_dynamic(const Simulation& simulation, Use&& use) {
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
        if (simulation.bodies()[b].dynamic()) {
            use(simulation.bodies()[b], b);
        }
    }
}

inline double mass_of(const SimulationBody& body) {
    return 1 / body.rigid->getInvMass();
}

/// The number of a body that the scene names.
inline std::size_t number_of(const Simulation& simulation, const std::string& name) {
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
        if (simulation.bodies()[b].name == name) {
            return b;
        }
    }
    throw std::runtime_error("no body is named " + name);
}

/// The farthest [m] that the mass centre of a dynamic body is from where it began.
inline double farthest_move(const Simulation& simulation) {
    double farthest = 0;
    for_each_dynamic(simulation, [&](const SimulationBody& body, std::size_t b) {
        const Vec3 start = body.start.pose * body.solid.body_in_file.position;
        farthest = std::max(farthest, (simulation.body_motion(b).pose.position - start).norm());
    });
    return farthest;
}

}  // namespace scree::gallery
