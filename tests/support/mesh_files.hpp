#pragma once

#include <filesystem>
#include <string>

#include <scree/mesh/triangle_mesh.hpp>

namespace scree::test {

/// The cube of edge 1 about the origin as 12 triangles.
TriangleMesh cube_mesh();

/// All of a file.
std::string contents(const std::filesystem::path& file);

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
    std::filesystem::path ply(const std::string& name, const TriangleMesh& mesh) const;
    /// One node with the mesh, scaled, then shifted.
    std::filesystem::path gltf(const std::string& name, const TriangleMesh& mesh, const Vec3& shift,
                               const Vec3& scale = Vec3::Ones()) const;
    /// The tetrahedron 0, x, 2y, 3z; `axis` is the up_axis element or nothing, `unit` its unit in metres.
    std::filesystem::path collada(const std::string& name, const std::string& axis, double unit) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace scree::test
