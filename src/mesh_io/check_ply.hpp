#pragma once

#include <filesystem>

namespace scree {

/// Throws MeshError for a PLY file that announces more elements than it has bytes, for which assimp makes
/// room before it reads one, or whose binary data end too early, beyond which assimp reads on.
void check_ply(const std::filesystem::path& file);

}  // namespace scree
