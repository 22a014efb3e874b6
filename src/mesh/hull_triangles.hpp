#pragma once

#include <array>
#include <vector>

#include <scree/mesh/vectors.hpp>

namespace scree {

using Triangle = std::array<int, 3>;

/// The hull of points of about unit size as triangles, counter-clockwise seen from outside; empty when Qhull
/// finds none. Qhull may give up, or turn a triangle inside out, where points are coplanar to rounding;
/// another `turn` of its working frame then mostly helps. Turn 0 is the frame as it is.
std::vector<Triangle> hull_triangles(const std::vector<Vec3>& points, int turn);

}  // namespace scree
