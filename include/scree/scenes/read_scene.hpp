#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <scree/scenes/scene_description.hpp>
#include <scree/scenes/scene_error.hpp>

namespace scree {

/// Reads a scene from the text of a scene file, `file` being where it came from. Each setting is a
/// KEY=VALUE with a dotted path, put into the scene before it is read. Throws SceneError.
SceneDescription parse_scene(std::string_view text, const std::filesystem::path& file,
                             const std::vector<std::string>& settings = {});

/// The same from the file itself.
SceneDescription read_scene(const std::filesystem::path& file, const std::vector<std::string>& settings = {});

/// Refuses what no file can say and no world can hold: names that lead nowhere or are used twice, a
/// half-space that could move, more bodies or rows than a machine takes. Throws SceneError.
void check_scene(const SceneDescription& scene);

}  // namespace scree
