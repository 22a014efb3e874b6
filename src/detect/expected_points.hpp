#pragma once

#include <vector>

#include "bullet_pair.hpp"

namespace scree {

/// Points where two parts may come to touch before the next update: the nearest ones, and those that would be
/// nearest if the smaller of the two were turned a little, to either side about two axes. Bullet's own way to
/// more than one point, made to look ahead. Those on one face have one normal; the nearest point is the
/// first.
std::vector<SurfacePoint> expected_points(btDispatcher& dispatcher, const ManifoldGeometry::Side& a,
                                          const ManifoldGeometry::Side& b,
                                          const ManifoldGeometry::Situation& now,
                                          const btDispatcherInfo& info);

}  // namespace scree
