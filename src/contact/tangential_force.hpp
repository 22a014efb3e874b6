#pragma once

#include <scree/contact/law.hpp>
#include <scree/contact/normal_force.hpp>
#include <scree/contact/tangential_constants.hpp>

namespace scree {

/// The vector f_t + (m_n/r̄) n [N], and its derivative when it is asked for.
struct TangentialForce {
    Vec3 force = Vec3::Zero();
    Mat39 rate;
};

/// The largest that it may be [N].
struct TangentialLimit {
    double force = 0;
    Row9 rate;
};

/// The relative motion across n; in three dimensions, and along the tangent of the x–z plane.
Slip sliding(const ContactInput& in);
Slip sliding_in_plane(const ContactInput& in);
/// Adds the turning about n over the contact's lever.
void add_spin(const ContactInput& in, Slip& slip);

/// The relative turning across n, over a radius [m].
Slip rolling_motion(const ContactInput& in, double radius);

/// What a spring keeps of its force when its stiffness changes from `before`: no energy is to be made.
inline double share_kept(double stiffness, double before) {
    return stiffness < before ? stiffness / before : 1;
}

/// A stored vector of the past as the step's formula has it, each straight from its own plane to the present
/// one. Where the stiffness has fallen since, the force has fallen with it, so that no energy is made; where
/// it has grown, the force stays. Notes in `out` a direction that was lost.
template <FrictionLaw friction>
TangentialForce carried_past(const ContactInput& in, const LawOptions& options,
                             const TangentialConstants& constants, Vec3 FrictionRecord::*which,
                             ContactForce& out);

/// Limits the constants as the step asks.
void cap(const ContactInput& in, TangentialConstants& constants);

/// Adds the increment −βh kt s, Eqs. (5.12), (5.15) and (5.17).
void stretch(const ContactInput& in, const Slip& slip, const TangentialConstants& constants,
             TangentialForce& spring);
/// Adds the damping −γt √(kt M) s, Eq. (5.21).
void damp(const ContactInput& in, const Slip& slip, const TangentialConstants& constants,
          TangentialForce& force);

/// Eqs. (5.16) and (5.29): what is larger than `most` is scaled back to `left`. Returns true when it was.
bool cut_off(const ContactInput& in, const TangentialLimit& most, const TangentialLimit& left,
             TangentialForce& force);

/// Friction in three dimensions without torsion, with a spring and a damper of one's own.
void add_friction_at_point(const ContactInput& in, const PressingForce& pressing, const LawOptions& options,
                           const Slip& slip, TangentialConstants& constants, ContactForce& out);

/// What the spring holds [J].
double stored_energy(const Vec3& force, const TangentialConstants& constants);

}  // namespace scree
