#pragma once

#include <scree/contact/law.hpp>
#include <scree/contact/law_options.hpp>

namespace scree {

/// N ≥ 0 [N], the elastic and the damping force that press the bodies together.
struct PressingForce {
    double size = 0;           ///< N [N]
    Row9 rate = Row9::Zero();  ///< by the nine unknowns, when asked for
};

/// N = Y V/Lc + cn V̇ ≥ 0, Eq. (5.7), along n at the centroid. On a flat patch the damping part is a traction,
/// whose moment about the centroid damps rocking, unless it is put at the centroid. Cohesion pulls with a
/// steady force, spread evenly over the patch, for as long as the bodies overlap, so that fn = N − cohesion;
/// friction and rolling resistance go by N (Derjaguin, Muller and Toporov; Mohr and Coulomb). Adds to `out`;
/// returns false when there is no force.
bool add_normal_force(const ContactInput& in, const LawOptions& options, ContactForce& out,
                      PressingForce& pressing);

/// V̇ [m³/s] from the same surface integral as S.
double volume_rate(const ContactGeometry& geometry, const RelativeMotion& motion);

}  // namespace scree
