#pragma once

#include <scree/contact/law.hpp>

namespace scree {

/// A stored friction record brought to the present. The torsional part keeps its size along the new normal.
struct CarriedForce {
    Vec3 force = Vec3::Zero();    ///< [N]
    Mat39 rate = Mat39::Zero();   ///< by the nine unknowns; set when rates are given
    bool lost_direction = false;  ///< the tangential part found no direction and starts from zero
};

/// In three dimensions: projected on the new tangent plane, Eq. (5.13), rescaled to its length, Eq. (5.14),
/// and turned about n by the mean turn of the two bodies, so that a pair that turns as one keeps its inner
/// force.
CarriedForce carry(const FrictionRecord& record, const Vec3& normal, const Quat& turn_a, const Quat& turn_b,
                   bool co_rotation, const MotionRates* rates);

/// In the x–z plane: the signed number along e_y × n stays what it was, however far n has turned, Fig. 5.17.
CarriedForce carry_in_plane(const FrictionRecord& record, const Vec3& normal, const MotionRates* rates);

/// The turn [rad] about a unit axis that a rotation contains.
double turn_about(const Vec3& axis, const Quat& rotation);

/// The tangent of the x–z plane, e_y × n made a unit vector; zero where n is along y.
Vec3 plane_tangent(const Vec3& normal);
/// Its derivative, from that of n.
Mat39 plane_tangent_rate(const Vec3& normal, const Mat39& normal_rate);

}  // namespace scree
