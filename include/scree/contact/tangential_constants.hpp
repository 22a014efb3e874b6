#pragma once

#include <scree/contact/law.hpp>
#include <scree/contact/law_options.hpp>

namespace scree {

/// The relative motion that friction works against, v_t + r̄ ω_n n.
struct Slip {
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    double lever = 0;              ///< r̄ [m]; 0 without torsion
    Mat39 rate;                    ///< by the nine unknowns; set when they are asked for
};

/// Spring and damper of the tangential force at the present contact.
struct TangentialConstants {
    double stiffness = 0;  ///< kt [N/m]
    double damping = 0;  ///< γt √(kt M) [N s/m], Eq. (5.21); kt is Yt Lc here, too, when it is without length
    bool vary = false;                   ///< whether the rates below may be other than zero
    Row9 stiffness_rate = Row9::Zero();  ///< of kt by the nine unknowns
    Row9 damping_rate = Row9::Zero();    ///< of the damping by the nine unknowns
};
/// By the options' TangentialStiffness and ReducedMass; with rates where `in` asks for them.
TangentialConstants tangential_constants(const ContactInput& in, const LawOptions& options, const Slip& slip);

/// The mass [kg] that two bodies oppose to a force along the slip, torsion included: 1/M = sᵀKs/sᵀs with
/// K = (1/m₁+1/m₂) 1 − [r₁]I₁⁻¹[r₁] − [r₂]I₂⁻¹[r₂] on its tangential part, which the source derives in
/// Eqs. (5.22)–(5.26), and r̄ n × the turning about n on its torsional part. Of no slip: M_red, Eq. (5.28).
struct EffectiveMass {
    double mass = 0;           ///< M [kg]
    Row9 rate = Row9::Zero();  ///< set when rates are asked for
};
/// Of the contact at hand along `slip`.
EffectiveMass effective_mass(const ContactInput& in, const Slip& slip);

}  // namespace scree
