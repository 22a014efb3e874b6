#pragma once

#include <vector>

#include <scree/scenes/simulation.hpp>

namespace scree {

/// Places the bodies of the scene's fill entries at random, clear of the others and of each other; bodies[i]
/// for i ≥ first get their solids and starts. Throws SceneError when they do not fit.
void fill_boxes(const SceneDescription& scene, const std::map<std::string, Solid>& solids,
                std::vector<SimulationBody>& bodies, std::size_t first);

}  // namespace scree
