#pragma once

#include <vector>

#include <scree/mesh/convex_polyhedron.hpp>
#include <scree/mesh/triangle_mesh.hpp>

namespace scree {

/// A closed mesh, outward, as convex solids that fill it exactly and share nothing: its hull, cut along the
/// planes of those triangles that lie inside, until none does. Empty when it would take more than `most`
/// cells.
std::vector<ConvexPolyhedron> convex_cells(const TriangleMesh& mesh, std::size_t most);

}  // namespace scree
