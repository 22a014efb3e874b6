#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree {

/// A scene that comes with scree.
struct ShippedScene {
    std::string name;            ///< by which `scree run` takes it
    std::string purpose;         ///< the first comment of its file
    std::filesystem::path file;  ///< where it is
};

/// The scenes that come with scree, by name.
std::vector<ShippedScene> shipped_scenes();

/// The file that `scene`, a file or the name of a shipped scene, stands for. Throws SceneError.
std::filesystem::path find_scene(const std::string& scene);

/// What a scene is called: its file's name without the ending, or the folder's where that is just "scene".
std::string scene_name(const std::filesystem::path& file);

}  // namespace scree
