#pragma once

#include <filesystem>

namespace scree {

/// Throws MeshError for a COLLADA file whose unit is no length or whose upward axis is none: assimp takes
/// what it does not understand for metres and y.
void check_collada_asset(const std::filesystem::path& file);

}  // namespace scree
