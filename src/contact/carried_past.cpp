#include <algorithm>

#include <scree/contact/carried_force.hpp>

#include "tangential_force.hpp"

namespace scree {

namespace {

template <FrictionLaw friction>
CarriedForce carried_record(const ContactInput& in, const LawOptions& options, std::size_t j,
                            Vec3 FrictionRecord::*which) {
    const FrictionRecord& past = in.history.past[j];
    const FrictionRecord record{.force = past.*which, .normal = past.normal};
    if constexpr (friction == FrictionLaw::cundall_strack_2d) {
        return carry_in_plane(record, in.geometry.normal, in.rates);
    } else {
        return carry(record, in.geometry.normal, in.step.turn_a[j], in.step.turn_b[j], options.co_rotation,
                     in.rates);
    }
}

// From the latest record's stiffness to the present one.
void soften(const ContactInput& in, const TangentialConstants& constants, TangentialForce& sum) {
    const double before = in.history.past[0].stiffness;
    if (!(constants.stiffness < before)) {
        return;
    }
    const double share = constants.stiffness / before;
    if (in.rates != nullptr) {
        sum.rate *= share;
        sum.rate.noalias() += sum.force / before * constants.stiffness_rate;
    }
    sum.force *= share;
}

}  // namespace

template <FrictionLaw friction>
TangentialForce carried_past(const ContactInput& in, const LawOptions& options,
                             const TangentialConstants& constants, Vec3 FrictionRecord::*which,
                             ContactForce& out) {
    TangentialForce sum;
    if (in.rates != nullptr) {
        sum.rate.setZero();
    }
    const auto& past = in.history.past;
    const std::size_t records = std::min(in.step.formula.past.size(), in.history.age);
    double kept = 1;  // of record j's force, at the latest record
    for (std::size_t j = 0; j < records; ++j) {
        kept *= j > 0 ? share_kept(past[j - 1].stiffness, past[j].stiffness) : 1;
        const double weight = in.step.formula.past[j] * kept;
        const CarriedForce carried = carried_record<friction>(in, options, j, which);
        sum.force += weight * carried.force;
        if (in.rates != nullptr) {
            sum.rate += weight * carried.rate;
        }
        out.lost_direction |= carried.lost_direction;
    }
    if (records > 0) {
        soften(in, constants, sum);
    }
    return sum;
}

template TangentialForce carried_past<FrictionLaw::cundall_strack>(const ContactInput&, const LawOptions&,
                                                                   const TangentialConstants&,
                                                                   Vec3 FrictionRecord::*, ContactForce&);
template TangentialForce carried_past<FrictionLaw::cundall_strack_2d>(const ContactInput&, const LawOptions&,
                                                                      const TangentialConstants&,
                                                                      Vec3 FrictionRecord::*, ContactForce&);

}  // namespace scree
