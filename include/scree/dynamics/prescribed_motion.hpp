#pragma once

#include <scree/dynamics/prescribed_path.hpp>

namespace scree {

/// The motion of a part of a machine: a frame that is displaced by s(t) and turned by R(t), steadily about an
/// axis through `about`, so that x(t) = x₀ + s(t) + (R(t) − 1)(x₀ − about) and q(t) = R(t) q₀. Without a
/// vibration s = velocity · t; with one s = amplitude sin(2π frequency t) d, where d is the direction of
/// `velocity`, whose size counts for nothing then. The point `about` itself is displaced by s. World axes.
struct PrescribedMotion {
    Vec3 velocity = Vec3::Zero();          ///< [m/s]
    Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
    Vec3 about = Vec3::Zero();             ///< [m], of the axis at time 0
    double amplitude = 0;                  ///< [m]; above 0: a vibration, with a frequency above 0
    double frequency = 0;                  ///< [1/s]
    /// [m/s], of a conveyor's surface against the body itself. Only its part in the plane of a contact
    /// counts: a belt drives what lies on it along, and neither lifts nor sinks.
    Vec3 surface_velocity = Vec3::Zero();

    /// Whether s is a vibration.
    [[nodiscard]] bool vibrates() const { return amplitude > 0; }
};

/// The path of a body whose frame is rigidly tied to one that moves so.
class PrescribedMotionPath final : public PrescribedPath {
  public:
    /// `start`: of the moving frame at time 0; `inner`: of the body's frame as seen from that.
    PrescribedMotionPath(const PrescribedMotion& motion, const Pose& start, const Pose& inner = {});

    [[nodiscard]] PathPoint at(double time) const override;
    [[nodiscard]] double reach(double begin, double end, double radius) const override;
    [[nodiscard]] double time_scale() const override;

  private:
    [[nodiscard]] double phase(double time) const;
    [[nodiscard]] Vec3 displacement(double time) const;
    [[nodiscard]] Vec3 drift_velocity(double time) const;

    PrescribedMotion motion_;
    Pose start_, inner_;
    Vec3 direction_ = Vec3::Zero();  ///< of the vibration
    Vec3 axis_ = Vec3::UnitZ();
    double spin_ = 0;  ///< about the axis [rad/s]
};

}  // namespace scree
