#pragma once

#include <scree/scenes/scene_description.hpp>

namespace scree {

/// What two of the scene's materials make together: the mixing rules, then what the pair's entry names.
PairMaterial pair_material(const SceneDescription& scene, const std::string& a, const std::string& b);

/// The restitution that Bullet's own solver takes for a pair: that of its damping ratio at a face of area
/// Lc², at most 1.
double pair_restitution(const PairMaterial& pair);

}  // namespace scree
