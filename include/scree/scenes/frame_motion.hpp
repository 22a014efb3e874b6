#pragma once

#include <scree/mesh/pose.hpp>

namespace scree {

/// Where a frame is and how it moves, in world axes.
struct FrameMotion {
    Pose pose;                             ///< of the frame
    Vec3 velocity = Vec3::Zero();          ///< [m/s], of the frame's origin
    Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
};

/// The motion of a frame that is rigidly tied to a moving one, at `inner` as seen from that.
inline FrameMotion tied(const FrameMotion& outer, const Pose& inner) {
    const Vec3 arm = outer.pose.orientation * inner.position;
    return {outer.pose * inner, outer.velocity + outer.angular_velocity.cross(arm), outer.angular_velocity};
}

}  // namespace scree
