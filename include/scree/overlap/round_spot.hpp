#pragma once

#include <scree/overlap/shape.hpp>

namespace scree {

/// The centre of curvature under a point of a shape's surface, and how far the surface is from it; of a
/// surface that is not round there, the point itself. Of a solid of revolution the centre is on the axis.
struct RoundSpot {
    Vec3 centre = Vec3::Zero();  ///< [m]
    double radius = 0;           ///< [m]
};
/// `out` is the unit normal there; all in the shape's frame.
RoundSpot round_spot(const Shape& shape, const Vec3& point, const Vec3& out);

}  // namespace scree
