#pragma once

#include <string>

#include <scree/mesh/triangle_mesh.hpp>

namespace scree {

/// A mesh as bytes, for another process of the same machine and build.
std::string packed(const TriangleMesh& mesh);
/// Instead of a mesh, why there is none.
std::string packed_error(const std::string& message);

/// The mesh of such bytes. Throws MeshError with the message when there is none.
TriangleMesh unpacked(const std::string& bytes);

}  // namespace scree
