#pragma once

#include <scree/contact/motion.hpp>
#include <scree/dynamics/trial.hpp>

namespace scree {

/// Of A's material at the contact against B's, without what conveyors do.
RelativeMotion relative_motion(const TrialBody& a, const TrialBody& b, const PairArms& arms);

/// Adds what conveyors do to a contact: the part of `surface`, the velocity of A's surface less that of B's
/// [m/s], that lies in the contact plane; to the rates too where they are given. The other rates do not
/// change: such a motion moves no boundary.
void add_surface_motion(const Vec3& surface, const Vec3& normal, RelativeMotion& motion, MotionRates* rates);

/// The derivatives of all that a law sees, by the nine unknowns.
void motion_rates(const ContactGeometry& geometry, const RelativeMotion& motion, const TrialBody& a,
                  const TrialBody& b, const PairArms& arms, double beta_h, MotionRates& rates);

}  // namespace scree
