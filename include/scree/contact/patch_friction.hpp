#pragma once

#include <scree/contact/law.hpp>
#include <scree/contact/law_options.hpp>
#include <scree/contact/normal_force.hpp>

namespace scree {

/// The first axis of the patch, which turns and tilts with the pair as a stored force does.
struct PatchAxis {
    Vec3 axis = Vec3::UnitX();  ///< unit, across the normal, world axes
    Mat39 rate;                 ///< by the nine unknowns; set when rates are given
    bool fresh = false;         ///< nothing is stored in these axes
};
/// `otherwise`: a unit vector across the normal, for a patch without a past or with one that lost its
/// direction.
PatchAxis patch_axis(const ContactHistory& history, const Vec3& normal, const Vec3& otherwise,
                     const FrictionStep& step, bool co_rotation, const MotionRates* rates);

/// Friction on the cells of a patch, Eqs. (5.13) to (5.17), (5.21) and (5.29) for each, with the share of the
/// normal force that the overlap's depth there gives it, and torsion about its own centre on the limit
/// surface of Friction. What resists spin of the whole patch is then the friction of its cells. Adds to
/// `out`; all work counts as tangential. `in.cells` must be set. Instantiated for every friction law in three
/// dimensions.
template <FrictionLaw friction>
void add_patch_friction(const ContactInput& in, const PressingForce& pressing, const LawOptions& options,
                        ContactForce& out);

}  // namespace scree
