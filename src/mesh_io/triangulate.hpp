#pragma once

#include <array>
#include <vector>

#include <scree/mesh/vectors.hpp>

namespace scree {

/// Splits a polygon into triangles of the same winding by cutting off ears. `loop` numbers its corners among
/// the points. One that is not simple is fanned from its first corner, which keeps its area vector and its
/// border.
std::vector<std::array<int, 3>> triangulated(const std::vector<Vec3>& points, const std::vector<int>& loop);

}  // namespace scree
