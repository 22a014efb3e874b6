#pragma once

#include <span>
#include <vector>

#include <scree/mesh/triangle_mesh.hpp>

namespace scree {

/// How coarse a decomposition may be.
struct DecompositionSetting {
    std::size_t least_parts;
    double concavity;          ///< that a part may have, in units of a thousandth of the mesh's diagonal
    std::size_t subdivisions;  ///< of all triangles into four, first
};
/// Those that are worth trying; none where the build is without HACD.
std::span<const DecompositionSetting> decomposition_settings();

/// Corners of convex pieces that together are about the mesh, by HACD; none of a mesh that is too fine for
/// it.
std::vector<std::vector<Vec3>> decompose(const TriangleMesh& mesh, const DecompositionSetting& setting);

}  // namespace scree
