#pragma once

#include <scree/overlap/shape.hpp>

namespace scree {

/// A direction along which two shapes are apart, and by how much: a bound from below on their distance.
struct Separation {
    Vec3 axis = Vec3::UnitZ();  ///< unit, from B to A
    double gap = 0;  ///< [m], of A's lowest point above B's highest one along the axis; may be negative
};

/// The best of the axes from centre to centre and along the faces that look most at the other shape.
Separation separation(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);

/// How far the shape reaches along a direction, max x·d [m] over its points in the outer frame; infinite for
/// a half-space along any direction but its normal.
double support(const Shape& shape, const Pose& pose, const Vec3& direction);

/// The least extent [m] of the shape along any normal of its faces; infinite for a half-space.
double width(const Shape& shape);

}  // namespace scree
