#pragma once

#include <vector>

#include <scree/mesh/convex_polyhedron.hpp>
#include <scree/mesh/triangle_mesh.hpp>

namespace scree {

/// A surface as convex plates, for ground of any shape: one for each flat convex stretch of it, which reaches
/// behind that by at most `thickness` [m], and no farther than half of the way to what else of the surface is
/// there. Plates that meet at an edge part it between them in the middle, so that no point has two and, near
/// the surface, none is left out. The front is where triangles are counter-clockwise. Triangles without area
/// make no plate.
std::vector<ConvexPolyhedron> surface_plates(const TriangleMesh& surface, double thickness);

}  // namespace scree
