#pragma once

#include <vector>

#include <scree/mesh/vectors.hpp>

namespace scree {

/// The unit normal of a loop's area vector, turned to where the vertices' heights have no slope left: the
/// cross products of a long strip lose what its width is smaller than its length. Zero for a loop without
/// area.
Vec3 loop_normal(const std::vector<Vec3>& points, const std::vector<int>& loop);

}  // namespace scree
