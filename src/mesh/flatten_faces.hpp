#pragma once

#include <vector>

#include <scree/mesh/vectors.hpp>

namespace scree {

/// Moves vertices of a convex polyhedron of about unit size so that every face of more than three vertices is
/// planar to rounding, by the smallest moves that do it (Newton on the incidences of vertices and planes,
/// which for a convex polyhedron do not depend on each other). Vertices of faces that are planar already
/// stay. Returns the moved points. Where it does not converge, faces remain unplanar: check them.
std::vector<Vec3> flattened(std::vector<Vec3> points, const std::vector<std::vector<int>>& loops);

/// The largest height of a loop's vertex over or under the plane of its area vector.
double unevenness(const std::vector<Vec3>& points, const std::vector<int>& loop);

}  // namespace scree
