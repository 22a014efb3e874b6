#pragma once

#include <scree/contact/law.hpp>
#include <scree/contact/law_options.hpp>
#include <scree/contact/normal_force.hpp>

namespace scree {

/// Friction with torsion on the limit surface ‖f_t‖² + (m_n/r̄)² ≤ (μ N)². Cundall and Strack's, Eqs. (5.12)
/// to (5.17), has a spring that is stored, a damper, Eq. (5.21), and a second cut-off of both together,
/// Eq. (5.29); the viscous one is that damper alone. μ is the static coefficient from when a contact sticks
/// until its spring exceeds it, and the kinetic one from then on until the spring falls short of that. Adds
/// to `out`. Instantiated for every friction law but none, with and
/// without torsion.
template <LawParts parts>
void add_friction(const ContactInput& in, const PressingForce& pressing, const LawOptions& options,
                  ContactForce& out);

}  // namespace scree
