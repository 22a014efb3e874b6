#pragma once

#include <scree/mesh/vectors.hpp>

namespace scree {

/// A rigid motion: x_outer = orientation · x_inner + position.
struct Pose {
    Vec3 position = Vec3::Zero();         ///< [m], in the outer frame
    Quat orientation = Quat::Identity();  ///< unit, from the inner to the outer frame

    [[nodiscard]] Vec3 operator*(const Vec3& point) const { return orientation * point + position; }
    /// The motion that applies `inner` first.
    [[nodiscard]] Pose operator*(const Pose& inner) const {
        return {*this * inner.position, orientation * inner.orientation};
    }
    [[nodiscard]] Pose inverse() const {
        const Quat back = orientation.conjugate();
        return {-(back * position), back};
    }
};

}  // namespace scree
