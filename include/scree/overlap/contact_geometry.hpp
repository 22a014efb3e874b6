#pragma once

#include <scree/mesh/vectors.hpp>

namespace scree {

using Mat6 = Eigen::Matrix<double, 6, 6>;   ///< by a motion (u, θ), of a force and a moment
using Mat36 = Eigen::Matrix<double, 3, 6>;  ///< of a vector by a motion (u, θ)

/// What two overlapping bodies A and B share at given poses: a function of the poses alone. World axes,
/// origin at the origin of A's shape, so that nothing is lost far from the world's origin.
///
/// Derivatives are taken with B held still, for a small rigid motion ξ = (u, θ) of A about the centroid c: a
/// point at c + r moves by u + θ × r. A common rigid motion of both bodies turns everything with it.
struct ContactGeometry {
    double volume = 0;                ///< V [m³]
    Vec3 centroid = Vec3::Zero();     ///< c [m], where the force acts
    Vec3 area_vector = Vec3::Zero();  ///< S [m²], of A's surface inside B, outward from A: dV = S·u at θ = 0
    Vec3 normal = Vec3::UnitZ();      ///< n = −S/‖S‖, the direction of the force on A
    double area = 0;                  ///< [m²], ‖S‖
    double depth = 0;                 ///< δ [m], the overlap's extent along n
    double lever = 0;  ///< r̄ = ∫‖p−c‖dA/A [m] of the patch seen along n; 0 for a smooth contact
    /// ∫ depth dV [m⁴] over the overlap with a half-space, whose force is its gradient; negative when there
    /// is none.
    double depth_moment = -1;
    bool flat_patch = false;   ///< the patch is polygonal: the damping is a traction on it
    bool centre_line = false;  ///< S vanishes (one inside the other): n is the line of centres

    Mat3 first_moment = Mat3::Zero();  ///< ∫ r n_Aᵀ dA [m³] over A's surface inside B
    Mat3 second_moment = Mat3::Zero();  ///< ∫ r (r×n_A)ᵀ dA [m⁴]; V dc = first_moment u + second_moment θ
    /// d(S, ∫ r×n_A dA) = boundary · ξ [m | m²]: an integral along the line where the two surfaces meet, the
    /// second part with the reference point held at c.
    Mat6 boundary = Mat6::Zero();
    Mat36 normal_rate = Mat36::Zero();  ///< dn = normal_rate · ξ
    /// Takes out of a moment of tractions along n what the true surface cannot transmit: a moment about the
    /// axis of a solid of revolution.
    Mat3 tilting = Mat3::Identity();

    /// ∫ r×n_A dA [m³]: dV = S·u + moment·θ.
    [[nodiscard]] Vec3 area_moment() const {
        return {first_moment(1, 2) - first_moment(2, 1), first_moment(2, 0) - first_moment(0, 2),
                first_moment(0, 1) - first_moment(1, 0)};
    }
};

/// The same contact with the bodies' roles exchanged; `shift` [m] leads from A's origin to B's.
ContactGeometry exchanged(const ContactGeometry& geometry, const Vec3& shift);

/// Turns everything from A's frame into world axes.
void rotate(ContactGeometry& geometry, const Mat3& turn);

/// Sets area, normal and normal_rate from S, or from the line of centres where S is too small a part of the
/// overlap's surface (‖S‖ < 10⁻³ of half of it; twice that once the line is in use, so that rounding does not
/// toggle). `apart` [m] leads from B's centre to A's, `arm` from the centroid to A's centre.
void set_normal(ContactGeometry& geometry, double surface, const Vec3& apart, const Vec3& arm,
                bool was_centre_line);

}  // namespace scree
