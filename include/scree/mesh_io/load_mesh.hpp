#pragma once

#include <filesystem>
#include <stdexcept>

#include <scree/mesh/triangle_mesh.hpp>

namespace scree {

/// A mesh file that cannot be used. The message is one sentence: the file, what was found, what was expected.
class MeshError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The triangles of a mesh file of any kind that assimp reads (OBJ, STL, PLY, COLLADA, glTF …), all its
/// meshes joined, placed by the file's own transforms, times `scale`. Equal points are one vertex;
/// coordinates are those of the file in single precision, widened unchanged. COLLADA and glTF are turned to z
/// up and to metres by what they declare, other kinds are taken as they are. Throws MeshError for a file that
/// is missing, unreadable, too large (1 GiB, 10 million vertices), without triangles or with coordinates that
/// are not finite; std::invalid_argument for a scale that is not positive.
///
/// The file is read in a copy of this process (fork), of bounded time and memory: a damaged file on which an
/// importer crashes is a MeshError too.
TriangleMesh load_mesh(const std::filesystem::path& file, const Vec3& scale = Vec3::Ones());

}  // namespace scree
