#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

/// Polyhedral discrete elements over Bullet. SI units, right-handed, world axes unless a name says otherwise.
namespace scree {

using Vec2 = Eigen::Vector2d;  ///< in a plane
using Vec3 = Eigen::Vector3d;  ///< a point or vector in space
using Mat3 = Eigen::Matrix3d;  ///< a turn or a tensor
/// Unit quaternion (w, x, y, z); turns vectors from a body's frame into the world's.
using Quat = Eigen::Quaterniond;

/// The matrix [a] with [a] b = a × b.
inline Mat3 cross_matrix(const Vec3& a) {
    Mat3 m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}

}  // namespace scree
