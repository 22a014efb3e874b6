#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scree/mesh/triangle_mesh.hpp>

namespace scree::test {

/// The cube of edge 1 about the origin as 12 triangles.
TriangleMesh cube_mesh();

/// All of a file.
std::string contents(const std::filesystem::path& file);

enum class PlyKind { ascii, little_endian, big_endian };

/// Where a glTF file has its numbers: as text in the file, in a file beside it, or in a binary file (.glb).
enum class GltfBuffer { embedded, beside, binary };

/// A folder for mesh files that goes away with the object. Each function writes one and gives its path.
class MeshFiles {
  public:
    MeshFiles();
    ~MeshFiles();
    MeshFiles(const MeshFiles&) = delete;
    MeshFiles& operator=(const MeshFiles&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

    std::filesystem::path text(const std::string& name, const std::string& text) const;
    std::filesystem::path obj(const std::string& name, const TriangleMesh& mesh) const;
    std::filesystem::path ascii_stl(const std::string& name, const TriangleMesh& mesh) const;
    std::filesystem::path binary_stl(const std::string& name, const TriangleMesh& mesh) const;
    std::filesystem::path ply(const std::string& name, const TriangleMesh& mesh,
                              PlyKind kind = PlyKind::ascii) const;
    /// One node with the mesh, scaled, then shifted.
    std::filesystem::path gltf(const std::string& name, const TriangleMesh& mesh, const Vec3& shift,
                               const Vec3& scale = Vec3::Ones()) const;
    /// The meshes and the JSON of the nodes, of which the first is the scene's.
    std::filesystem::path gltf(const std::string& name, const std::vector<TriangleMesh>& meshes,
                               const std::string& nodes, GltfBuffer where) const;
    /// The tetrahedron 0, x, 2y, 3z as #corner; `axis` is the up_axis element or nothing, `unit` its unit in
    /// metres, `nodes` are the scene's.
    std::filesystem::path collada(
        const std::string& name, const std::string& axis, double unit,
        const std::string& nodes = R"(<node><instance_geometry url="#corner"/></node>)") const;

  private:
    std::filesystem::path folder_;
};

}  // namespace scree::test
