#pragma once

#include <filesystem>

#include <scree/mesh/triangle_mesh.hpp>

namespace scree {

/// What load_mesh gives, read in this process: a damaged file may do it harm.
TriangleMesh read_mesh(const std::filesystem::path& file, const Vec3& scale);

}  // namespace scree
