#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace scree {

using Json = nlohmann::json;

/// JSON with comments. Refuses duplicate keys, numbers that no double holds, and nesting deeper than a scene
/// needs. Throws SceneError; `place` is what its message begins with, and `lines` whether it gives the line.
Json parse_json(std::string_view text, const std::string& place, bool lines = true);

/// The text of a scene file, bounded in size. Throws SceneError.
std::string read_text(const std::filesystem::path& file);

/// The value as an error message shows it: on one line, and short.
std::string shown(const Json& value);
/// A word in quotes, likewise.
std::string in_quotes(std::string_view word);

/// Puts VALUE at KEY of a setting KEY=VALUE; objects on the way are made where they are missing. A VALUE that
/// is no JSON is a string. Throws SceneError.
void apply_setting(Json& scene, const std::string& setting);

}  // namespace scree
