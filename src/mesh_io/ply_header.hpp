#pragma once

#include <filesystem>

namespace scree {

/// Throws MeshError for a PLY file whose header announces more elements than it has bytes: assimp makes room
/// for all of them before it reads one.
void check_ply_header(const std::filesystem::path& file);

}  // namespace scree
