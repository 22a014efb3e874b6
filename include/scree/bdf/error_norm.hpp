#pragma once

#include <span>

#include <scree/dynamics/trial.hpp>

namespace scree {

/// The tolerances of a run, dimensionless, and the scale that gravity sets.
struct Tolerances {
    double relative = 1e-3;  ///< rtol
    double absolute = 1e-6;  ///< atol
    double gravity = 9.81;   ///< ‖g‖ [m/s²]

    /// What both allow together, for errors are over scales of their own.
    [[nodiscard]] double sum() const { return relative + absolute; }

    /// What the local error of one step of a formula of this order may be. A method of order q that allows an
    /// error ε a step makes one of ε^{q/(q+1)} a second; so a step is allowed less than the sum, by as much
    /// as makes the error of a run proportional to the tolerance. At a sum of 10⁻³ and above it is the sum.
    [[nodiscard]] double a_step(std::size_t order) const;
};

/// An error, or any small change, of one body's state.
struct BodyError {
    Vec3 position,  ///< [m]
        angle,      ///< [rad]
        velocity,   ///< [m/s]
        spin;       ///< [rad/s]
};

/// What a body's errors are measured by, for tolerance 1: ℓ for positions, one radian for angles, and for
/// velocities max(‖v‖, √(‖g‖ℓ)), the same over ℓ for spins. Without gravity and at rest, the fastest body's
/// speed.
class ErrorScale {
  public:
    /// At trial velocities; both lists must outlive it. `gravity` is ‖g‖ [m/s²].
    ErrorScale(std::span<const Body> bodies, std::span<const TrialBody> trial, double gravity);

    /// Root mean square of a body's errors over its weights.
    [[nodiscard]] double norm(std::size_t body, const BodyError& error) const;

  private:
    std::span<const Body> bodies_;
    std::span<const TrialBody> trial_;
    double gravity_;
    double fastest_;  ///< [m/s]
};

}  // namespace scree
