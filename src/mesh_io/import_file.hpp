#pragma once

#include <filesystem>

#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <scree/mesh/vectors.hpp>

namespace scree {

/// A file as assimp reads it.
class ImportedFile {
  public:
    /// Throws MeshError.
    explicit ImportedFile(const std::filesystem::path& file);

    [[nodiscard]] const aiScene& scene() const { return *scene_; }
    /// From assimp's frame for this kind of file to ours, z up.
    [[nodiscard]] const Mat3& to_z_up() const { return to_z_up_; }

  private:
    Assimp::Importer importer_;
    const aiScene* scene_ = nullptr;  // owned by the importer
    Mat3 to_z_up_ = Mat3::Identity();
};

}  // namespace scree
