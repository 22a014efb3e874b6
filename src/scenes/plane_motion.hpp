#pragma once

#include <map>

#include <scree/scenes/scene_description.hpp>
#include <scree/scenes/solid.hpp>

namespace scree {

/// Refuses a scene whose friction law is for motion in the x–z plane, and in which something would leave it.
/// Throws SceneError.
void check_plane_motion(const SceneDescription& scene);

/// The same for the meshes, which have to be their own mirror images where their bodies are. `solids` by the
/// names of their shapes.
void check_plane_meshes(const SceneDescription& scene, const std::map<std::string, Solid>& solids);

}  // namespace scree
