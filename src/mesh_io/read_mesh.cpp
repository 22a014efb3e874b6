#include "read_mesh.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>

#include <scree/mesh_io/load_mesh.hpp>

#include "import_file.hpp"
#include "triangulate.hpp"

namespace scree {

namespace {

constexpr std::size_t most_vertices = 10'000'000;

struct PointHash {
    std::size_t operator()(const std::array<double, 3>& point) const {
        std::uint64_t hash = 0;
        for (const double x : point) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15U;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

/// Collects triangles, joining equal points.
class Joiner {
  public:
    int vertex(const Vec3& point) {
        // Adding zero makes −0 the same as 0.
        const std::array<double, 3> key{point.x() + 0.0, point.y() + 0.0, point.z() + 0.0};
        const auto [place, is_new] = numbers_.emplace(key, static_cast<int>(mesh_.vertices.size()));
        if (is_new) {
            mesh_.vertices.push_back(point);
        }
        return place->second;
    }
    void triangle(int a, int b, int c) { mesh_.triangles.push_back({a, b, c}); }
    TriangleMesh take() { return std::move(mesh_); }

  private:
    TriangleMesh mesh_;
    std::unordered_map<std::array<double, 3>, int, PointHash> numbers_;
};

using Affine = Eigen::Transform<double, 3, Eigen::Affine>;

/// A mesh of the scene and where a node puts it.
struct Placed {
    const aiMesh* mesh = nullptr;
    Affine place;
};

Affine widened(const aiMatrix4x4& matrix) {
    Affine place;
    for (unsigned row = 0; row < 3; ++row) {
        for (unsigned column = 0; column < 4; ++column) {
            place(row, column) = static_cast<double>(matrix[row][column]);
        }
    }
    place.makeAffine();
    return place;
}

std::vector<Placed> placed_meshes(const aiScene& scene, const Affine& outermost) {
    std::vector<Placed> meshes;
    std::vector<std::pair<const aiNode*, Affine>> open;
    if (scene.mRootNode != nullptr) {
        open.emplace_back(scene.mRootNode, outermost);
    }
    while (!open.empty()) {
        const auto [node, outer] = open.back();
        open.pop_back();
        const Affine place = outer * widened(node->mTransformation);
        for (unsigned i = 0; i < node->mNumMeshes; ++i) {
            meshes.push_back({scene.mMeshes[node->mMeshes[i]], place});
        }
        for (unsigned i = node->mNumChildren; i > 0; --i) {
            open.emplace_back(node->mChildren[i - 1], place);
        }
    }
    return meshes;
}

/// The numbers of a face's points, checked.
std::vector<int> corners(const aiFace& face, const std::vector<Vec3>& points, const std::string& file) {
    std::vector<int> loop;
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
        const unsigned number = face.mIndices[i];
        if (number >= points.size()) {
            throw MeshError(file + ": found a face with vertex " + std::to_string(number) +
                            ", expected less than " + std::to_string(points.size()));
        }
        if (!points[number].allFinite()) {
            throw MeshError(file + ": found a coordinate that is not finite at vertex " +
                            std::to_string(number) + ", expected numbers within single precision");
        }
        loop.push_back(static_cast<int>(number));
    }
    return loop;
}

void append(Joiner& joiner, const Placed& placed, const std::string& file) {
    const bool mirrored = placed.place.linear().determinant() < 0;
    std::vector<Vec3> points(placed.mesh->mNumVertices);
    for (unsigned v = 0; v < placed.mesh->mNumVertices; ++v) {
        const aiVector3D& p = placed.mesh->mVertices[v];
        points[v] = placed.place * Eigen::Vector3f(p.x, p.y, p.z).cast<double>();
    }
    for (unsigned f = 0; f < placed.mesh->mNumFaces; ++f) {
        // Points and lines bound nothing and give no triangles.
        for (const auto& [a, b, c] : triangulated(points, corners(placed.mesh->mFaces[f], points, file))) {
            const int first = joiner.vertex(points[a]);
            const int second = joiner.vertex(points[b]);
            const int third = joiner.vertex(points[c]);
            joiner.triangle(first, mirrored ? third : second, mirrored ? second : third);
        }
    }
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& file, const Vec3& scale) {
    const ImportedFile imported(file);
    const Affine outermost(scale.asDiagonal() * imported.to_z_up());
    const std::vector<Placed> meshes = placed_meshes(imported.scene(), outermost);
    std::size_t vertices = 0;
    for (const Placed& placed : meshes) {
        vertices += placed.mesh->mNumVertices;
    }
    if (vertices > most_vertices) {
        throw MeshError(file.string() + ": found " + std::to_string(vertices) +
                        " vertices, expected at most " + std::to_string(most_vertices));
    }
    Joiner joiner;
    for (const Placed& placed : meshes) {
        append(joiner, placed, file.string());
    }
    TriangleMesh mesh = joiner.take();
    if (mesh.triangles.empty()) {
        throw MeshError(file.string() + ": found no triangles, expected a surface");
    }
    return mesh;
}

}  // namespace scree
