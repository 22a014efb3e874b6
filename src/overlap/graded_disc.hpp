#pragma once

#include <vector>

#include <Eigen/Core>

namespace scree {

/// The corners, counter-clockwise, of a polygon that stands for the unit disc, symmetric to the x axis. Its
/// sides grow in proportion to their distance from the point (1, 0), so that it cuts as the circle does at
/// every scale there: of a segment next to that point, however small, area and width are the circle's within
/// 0.0014 and 0.01. The whole has the circle's area, its centroid and equal second moments about all axes.
const std::vector<Eigen::Vector2d>& graded_disc();

}  // namespace scree
