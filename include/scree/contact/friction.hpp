#pragma once

#include <scree/contact/law.hpp>

namespace scree {

/// A stored friction record brought to the present: projected on the new tangent plane, Eq. (5.13), rescaled
/// to its length, Eq. (5.14), and turned about n by the mean turn of the two bodies, so that a pair that
/// turns as one keeps its inner force. The torsional part keeps its size along the new normal.
struct CarriedForce {
    Vec3 force = Vec3::Zero();    ///< [N]
    Mat39 rate = Mat39::Zero();   ///< by the nine unknowns; set when rates are given
    bool lost_direction = false;  ///< the projection vanished: the tangential part starts from zero
};
CarriedForce carry(const FrictionRecord& record, const Vec3& normal, const Quat& turn_a, const Quat& turn_b,
                   bool co_rotation, const MotionRates* rates);

/// The turn [rad] about a unit axis that a rotation contains.
double turn_about(const Vec3& axis, const Quat& rotation);

/// Cundall–Strack friction with torsion on the limit surface ‖f_t‖² + (m_n/r̄)² ≤ (μ fn)², Eqs. (5.13)–(5.17),
/// (5.21) and (5.29). Adds to `out`, of which normal_force must be set.
template <bool with_torsion>
void add_friction(const ContactInput& in, const Row9& normal_force_rate, bool co_rotation, ContactForce& out);

}  // namespace scree
