#pragma once

#include <string>

#include <scree/mesh/pose.hpp>

namespace scree {

/// Where a body is and how it moves, by the frame of its file, in world axes.
struct BodyRecord {
    std::string name;                      ///< of the body
    Pose pose;                             ///< of the file's frame
    Vec3 velocity = Vec3::Zero();          ///< [m/s], of the frame's origin
    Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
};

}  // namespace scree
