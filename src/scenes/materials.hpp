#pragma once

#include <scree/scenes/scene_description.hpp>
#include <scree/world/dynamics_world.hpp>

namespace scree {

/// What two of the scene's materials make together: the mixing rules, then what the pair's entry names.
PairMaterial pair_material(const SceneDescription& scene, const std::string& a, const std::string& b);

/// The contact law that the scene asks for, without the parts that it cannot enter.
void set_law(const SceneDescription& scene, DynamicsWorld& world);

}  // namespace scree
