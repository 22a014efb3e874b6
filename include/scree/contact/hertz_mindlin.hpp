#pragma once

#include <scree/contact/law.hpp>

namespace scree {

/// Balls on one another and on flat walls by Hertz and Mindlin: fn = ⁴⁄₃ E* √R* δ^(3/2), E* = Y/(2(1−ν²))
/// with the pair's Y, and a tangential spring of stiffness 8 G* √(R*δ), G* = Y/(4(2−ν)(1+ν)), whose force
/// shrinks with it on the way back, cut off at μ fn. Both have dashpots 2√(5/6) β √(k M_red) with k the
/// present stiffness, 2E* √(R*δ) in the normal direction (Tsuji, Tanaka and Ishida 1992), which make a
/// restitution that does not depend on speed.
///
/// R* is taken from the overlap, V/(πδ²) + δ/3: exact on a flat wall, and off by δ/4 between two like balls.
/// A law for DynamicsWorld::set_contact_law.
struct HertzMindlin {
    static constexpr bool gives_rates = true;  ///< in closed form
    static constexpr bool gives_power = true;  ///< see ContactPower

    double poisson_ratio = 0.3;     ///< ν, of both bodies
    double normal_damping = 0;      ///< β
    double tangential_damping = 0;  ///< β

    /// Fills `out` by the law.
    void operator()(const ContactInput& in, ContactForce& out) const;
};

/// β for a restitution in (0, 1] of a contact that cannot pull. Throws std::invalid_argument for others.
double hertz_damping(double restitution);

}  // namespace scree
