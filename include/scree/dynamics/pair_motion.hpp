#pragma once

#include <scree/contact/motion.hpp>
#include <scree/dynamics/trial.hpp>

namespace scree {

RelativeMotion relative_motion(const TrialBody& a, const TrialBody& b, const PairArms& arms);

/// The derivatives of all that a law sees, by the nine unknowns.
void motion_rates(const ContactGeometry& geometry, const RelativeMotion& motion, const TrialBody& a,
                  const TrialBody& b, const PairArms& arms, double beta_h, MotionRates& rates);

}  // namespace scree
