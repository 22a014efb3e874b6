#pragma once

#include <variant>

#include <scree/mesh/convex_polyhedron.hpp>

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

/// A convex solid in its own frame.
using Shape = std::variant<ConvexPolyhedron, HalfSpace, Sphere>;

/// Radius [m] of the ball about the frame's origin that holds the shape; infinite for a half-space.
double bounding_radius(const Shape& shape);

/// Lowest and highest corner [m] of the smallest axis-aligned box that holds the shape at a pose.
struct Bounds {
    Vec3 low, high;
};
Bounds bounds(const Shape& shape, const Pose& pose);

}  // namespace scree
