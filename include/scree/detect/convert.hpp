#pragma once

#include <LinearMath/btTransform.h>

#include <scree/mesh/pose.hpp>

namespace scree {

/// The same vector.
inline Vec3 to_eigen(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

/// The same vector.
inline btVector3 to_bullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// The basis of the transform may be off a rotation by rounding.
inline Pose to_eigen(const btTransform& transform) {
    Mat3 turn;
    for (int row = 0; row < 3; ++row) {
        turn.row(row) = to_eigen(transform.getBasis()[row]);
    }
    return {to_eigen(transform.getOrigin()), Quat(turn).normalized()};
}

/// The same motion.
inline btTransform to_bullet(const Pose& pose) {
    const Mat3 m = pose.orientation.toRotationMatrix();
    return btTransform(
        btMatrix3x3(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)),
        to_bullet(pose.position));
}

}  // namespace scree
