#pragma once

#include <scree/mesh/pose.hpp>

namespace scree {

/// Where a prescribed body is at one time, and how it moves; world axes.
struct PathPoint {
    Pose pose;                             ///< of the body's frame
    Vec3 velocity = Vec3::Zero();          ///< [m/s], of that frame's origin
    Vec3 spin = Vec3::Zero();              ///< ω [rad/s]
    Vec3 surface_velocity = Vec3::Zero();  ///< [m/s], see TrialBody
};

/// A motion that is a function of time and nothing else, known at any time: at the end of every trial step,
/// whatever method makes it.
class PrescribedPath {
  public:
    /// Made by those that derive from it.
    PrescribedPath() = default;
    virtual ~PrescribedPath() = default;
    PrescribedPath(const PrescribedPath&) = delete;
    PrescribedPath& operator=(const PrescribedPath&) = delete;

    /// At a time [s], not before 0.
    [[nodiscard]] virtual PathPoint at(double time) const = 0;
    /// A bound [m] on how far any point within `radius` [m] of the frame's origin is, between two times [s],
    /// from where it was at the first.
    [[nodiscard]] virtual double reach(double begin, double end, double radius) const = 0;
    /// The time [s] in which the velocity changes by as much as itself: 1/Ω of sin Ωt; infinite when it does
    /// not change.
    [[nodiscard]] virtual double time_scale() const = 0;
};

}  // namespace scree
