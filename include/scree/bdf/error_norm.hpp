#pragma once

#include <scree/dynamics/step_problem.hpp>

namespace scree {

/// The tolerances of a run, dimensionless, and the scale that gravity sets.
struct Tolerances {
    double relative = 1e-3;
    double absolute = 1e-6;
    double gravity = 9.81;  ///< ‖g‖ [m/s²]

    [[nodiscard]] double sum() const { return relative + absolute; }
};

/// An error, or any small change, of one body's state.
struct BodyError {
    Vec3 position, angle, velocity, spin;  ///< [m], [rad], [m/s], [rad/s]
};

/// What a body's errors are measured by, for tolerance 1: ℓ for positions, one radian for angles, and for
/// velocities max(‖v‖, √(‖g‖ℓ)), the same over ℓ for spins. Without gravity and at rest, the fastest body's
/// speed.
class ErrorScale {
  public:
    ErrorScale(std::span<const Body> bodies, std::span<const TrialBody> trial, double gravity);

    /// Root mean square of a body's errors over its weights.
    [[nodiscard]] double norm(std::size_t body, const BodyError& error) const;

  private:
    std::span<const Body> bodies_;
    std::vector<double> speed_;  ///< [m/s], one a body
};

}  // namespace scree
