#pragma once

#include <vector>

#include <scree/output/shown_scene.hpp>
#include <scree/scenes/simulation.hpp>

namespace scree {

/// A scene to be looked at: a mesh a shape, and each body at its start.
ShownScene shown_scene_of(const Simulation& simulation);

/// Whether it is not fixed.
bool moves(const SimulationBody& body);

/// Where those that move are, in scene order.
std::vector<Pose> moving_poses(const Simulation& simulation);

}  // namespace scree
