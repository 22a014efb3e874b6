#pragma once

#include <variant>

#include <scree/overlap/round_shape.hpp>

namespace scree {

/// Solid where normal·x < offset.
struct HalfSpace {
    Vec3 normal = Vec3::UnitZ();  ///< unit, out of the solid
    double offset = 0;            ///< [m]
};

/// Centred on the frame's origin.
struct Sphere {
    double radius = 0;  ///< [m]
};

/// A surface that encloses nothing, of which only a box that holds it is known here: it has no overlap, and
/// contact with it needs a PairGeometry.
struct OpenSurface {
    Vec3 low = Vec3::Zero();   ///< [m], corners of the box
    Vec3 high = Vec3::Zero();  ///< [m]
};

/// A solid in its own frame; all but an open surface are convex.
using Shape = std::variant<ConvexPolyhedron, HalfSpace, Sphere, Frustum, Capsule, OpenSurface>;

/// Radius [m] of the ball about the frame's origin that holds the shape; infinite for a half-space.
double bounding_radius(const Shape& shape);

/// How far [m] the shape reaches along a unit direction of its own frame, from the origin; infinite for a
/// half-space in all directions but its normal.
double reach_along(const Shape& shape, const Vec3& direction);

/// Lowest and highest corner [m] of the smallest axis-aligned box that holds the shape at a pose.
struct Bounds {
    Vec3 low,  ///< the lowest
        high;  ///< the highest
};
/// In the frame in which the pose is given; of a half-space infinite, but for the side on which an axis
/// leaves it.
Bounds bounds(const Shape& shape, const Pose& pose);

}  // namespace scree
