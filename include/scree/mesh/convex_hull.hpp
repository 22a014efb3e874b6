#pragma once

#include <vector>

#include <scree/mesh/convex_polyhedron.hpp>

namespace scree {

/// The convex hull of points.
struct ConvexHull {
    ConvexPolyhedron solid;   ///< in the frame of the points
    double largest_move = 0;  ///< [m], the farthest a vertex was moved onto the plane of its merged face
};

/// The hull of points by Qhull. Triangles that are coplanar to 10⁻⁶ of the size are merged into one face, and
/// the vertices of a merged face moved onto its plane, by the smallest moves that do it and at most 10⁻⁶ of
/// the size; a face that cannot be made planar to 10⁻¹² of the size that way stays triangulated. Of points
/// nearer to each other than 10⁻⁶ of the size one is taken. No vertex is higher above a face than 10⁻¹² of
/// the size, but for the rounding of coordinates far from the origin. Throws std::invalid_argument, naming
/// the reason, for points that are too few, not finite, out of range (larger than 10⁹ m or closer together
/// than 10⁻⁹ m), or thinner than 10⁻⁵ of their size.
ConvexHull convex_hull(const std::vector<Vec3>& points);

}  // namespace scree
