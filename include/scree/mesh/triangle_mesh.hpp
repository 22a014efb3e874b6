#pragma once

#include <array>
#include <vector>

#include <scree/mesh/vectors.hpp>

namespace scree {

/// Triangles over shared vertices, counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<Vec3> vertices;                 ///< [m], in the file's frame
    std::vector<std::array<int, 3>> triangles;  ///< numbers of vertices
};

}  // namespace scree
