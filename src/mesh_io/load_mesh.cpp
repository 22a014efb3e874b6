#include <scree/mesh_io/load_mesh.hpp>

#include <stdexcept>
#include <string>

#include <scree/mesh_io/isolated.hpp>

#include "guarded_files.hpp"
#include "packed_mesh.hpp"
#include "read_mesh.hpp"

namespace scree {

namespace {

/// Generous for any file of its size: assimp takes some 10 s and 10 GB for a gigabyte.
IsolationLimits limits_for(std::uintmax_t bytes) {
    constexpr std::uintmax_t mebibyte = 1 << 20;
    return {static_cast<unsigned>(10 + bytes / mebibyte), (1024 + 64 * (bytes / mebibyte)) * mebibyte};
}

}  // namespace

TriangleMesh load_mesh(const std::filesystem::path& file, const Vec3& scale) {
    if (!scale.allFinite() || scale.minCoeff() <= 0) {
        throw std::invalid_argument("the scale of a mesh must be positive and finite");
    }
    if (const std::string obstacle = GuardedFiles::obstacle(file.string()); !obstacle.empty()) {
        throw MeshError(file.string() + ": " + obstacle + ", expected a mesh file");
    }
    const auto work = [&]() -> std::string {
        try {
            return packed(read_mesh(file, scale));
        } catch (const MeshError& error) {
            return packed_error(error.what());
        }
    };
    try {
        return unpacked(run_isolated(work, limits_for(std::filesystem::file_size(file))));
    } catch (const IsolationError& error) {
        throw MeshError(file.string() + ": found no mesh in it (" + error.what() +
                        "), expected a kind of mesh file that assimp reads");
    }
}

}  // namespace scree
