#pragma once

#include <scree/contact/law.hpp>
#include <scree/contact/law_options.hpp>
#include <scree/contact/normal_force.hpp>

namespace scree {

/// Rolling resistance: a spring against the relative turning across n over the radius R = Lc/2, with the
/// stiffness and the damping of the tangential one and a memory and cut-offs of its own. Its moment is at
/// most μ_r R N, so that a ball stands still on slopes up to atan μ_r. Adds to `out`.
void add_rolling(const ContactInput& in, const PressingForce& pressing, const LawOptions& options,
                 ContactForce& out);

}  // namespace scree
