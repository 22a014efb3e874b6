#pragma once

#include <scree/mesh/triangle_mesh.hpp>

namespace scree {

/// A triangle soup and what was found out about it.
struct Surface {
    TriangleMesh mesh;     ///< triangles of three different vertices; of a closed surface all face outward
    bool closed = false;   ///< encloses a volume, with no open edge
    bool flipped = false;  ///< some triangles were turned round to get there
};

/// Examines a triangle soup over joined vertices. Where neighbours are turned against each other, they are
/// made to agree; a surface that is inside out is turned.
Surface oriented_surface(const TriangleMesh& mesh);

}  // namespace scree
