#pragma once

#include <vector>

#include <scree/mesh/convex_polyhedron.hpp>

namespace scree {

struct ConvexHull {
    ConvexPolyhedron solid;   ///< in the frame of the points
    double largest_move = 0;  ///< [m], the farthest a vertex was moved onto the plane of its merged face
};

/// The hull of points by Qhull. Triangles that are coplanar to 10⁻⁶ of the size are merged into one face, and
/// the vertices of a merged face moved onto its plane; a face that cannot be made planar to 10⁻¹² of the size
/// that way stays triangulated. Throws std::invalid_argument, naming the reason, for points that are too few,
/// not finite, out of range, or without volume.
ConvexHull convex_hull(const std::vector<Vec3>& points);

}  // namespace scree
