#pragma once

#include <scree/contact/law.hpp>
#include <scree/contact/law_options.hpp>

namespace scree {

/// fn = Y V/Lc + cn V̇ ≥ 0, Eq. (5.7), along n at the centroid. On a flat patch the damping part is a
/// traction, whose moment about the centroid damps rocking, unless it is put at the centroid. Adds to `out`;
/// returns false when there is no force.
bool add_normal_force(const ContactInput& in, const LawOptions& options, ContactForce& out,
                      Row9& normal_force_rate);

/// V̇ [m³/s] from the same surface integral as S.
double volume_rate(const ContactGeometry& geometry, const RelativeMotion& motion);

}  // namespace scree
