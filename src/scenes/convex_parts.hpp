#pragma once

#include <filesystem>
#include <vector>

#include <scree/mesh_io/describe_mesh.hpp>
#include <scree/scenes/scene_description.hpp>

namespace scree {

/// Convex solids that together are a mesh, in the file's frame times its scale.
struct ConvexParts {
    std::vector<ConvexPolyhedron> solids;
    double volume_ratio = 0;  ///< of their union, over the mesh
};

/// Of the files that a shape names, one each. Throws std::exception when a file cannot be used, or when they
/// do not fill the mesh within a hundredth of its volume.
ConvexParts parts_from_files(const MeshShape& shape, const MeshDescription& mesh,
                             const std::filesystem::path& folder);

/// By hierarchical approximate convex decomposition, with one setting after another until the parts fill the
/// mesh within a hundredth of its volume; then by cuts along the mesh's own planes. Throws
/// std::invalid_argument, with the best figure, when neither does.
ConvexParts decomposed(const MeshDescription& mesh);

}  // namespace scree
