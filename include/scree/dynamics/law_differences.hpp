#pragma once

#include <scree/contact/material.hpp>
#include <scree/dynamics/trial.hpp>

namespace scree {

/// How far each of a pair's nine unknowns is moved to difference a law: so that the bodies move by the
/// geometric mean of the depth and of its rounding, where the two errors of a difference are alike.
class DifferenceSteps {
  public:
    /// `depth` [m], of the contact; `beta_h` [s] > 0.
    DifferenceSteps(const PairConstants& pair, double depth, double beta_h);
    /// [m/s] for the first three unknowns, [rad/s] for the others.
    [[nodiscard]] double of(int unknown) const { return unknown < 3 ? velocity_ : spin_; }

  private:
    double velocity_, spin_;
};

/// A pair with one of its nine unknowns, see MotionRates, changed by a step, and its poses with it.
struct NudgedPair {
    TrialBody a,  ///< with its pose as the velocities lead
        b;        ///< likewise

    /// Of A and B as they are, `unknown` from 0 to 8; `step` [m/s] or [rad/s], `beta_h` [s].
    NudgedPair(const TrialBody& at_a, const TrialBody& at_b, int unknown, double step, double beta_h);
};

}  // namespace scree
