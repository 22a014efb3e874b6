#pragma once

#include <scree/mesh/vectors.hpp>

namespace scree {

/// A rigid motion: x_outer = orientation · x_inner + position.
struct Pose {
    Vec3 position = Vec3::Zero();         ///< [m], in the outer frame
    Quat orientation = Quat::Identity();  ///< unit, from the inner to the outer frame

    /// The outer coordinates [m] of a point given by its inner ones.
    [[nodiscard]] Vec3 operator*(const Vec3& point) const { return orientation * point + position; }
    /// The motion that applies `inner` first.
    [[nodiscard]] Pose operator*(const Pose& inner) const {
        return {*this * inner.position, orientation * inner.orientation};
    }
    /// The motion back, from the outer to the inner frame.
    [[nodiscard]] Pose inverse() const {
        const Quat back = orientation.conjugate();
        return {-(back * position), back};
    }
};

/// A bound [m] on how far the points of a ball about the inner origin are apart in two poses.
inline double largest_move(const Pose& from, const Pose& to, double radius) {
    const double half_turn = (to.orientation * from.orientation.conjugate()).vec().norm();  // its sine
    return (to.position - from.position).norm() + (half_turn > 0 ? 2 * radius * half_turn : 0);
}

}  // namespace scree
