#pragma once

#include <scree/scenes/scene_description.hpp>

namespace scree {

/// The names of all bodies, in scene order: their own, or shape and number, counted per shape. Throws
/// SceneError for a name used twice.
std::vector<std::string> body_names(const SceneDescription& scene);

}  // namespace scree
