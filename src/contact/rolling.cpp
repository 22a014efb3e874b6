#include <scree/contact/rolling.hpp>

#include "tangential_force.hpp"

namespace scree {

namespace {

// Takes the turning over the radius back to a moment.
void apply(const ContactInput& in, double radius, const TangentialForce& rolling, ContactForce& out) {
    out.moment += radius * rolling.force;
    if (in.rates != nullptr) {
        out.moment_rate += radius * rolling.rate;
    }
}

}  // namespace

void add_rolling(const ContactInput& in, const PressingForce& pressing, const LawOptions& options,
                 ContactForce& out) {
    const double radius = 0.5 * in.pair.length;
    const TangentialLimit limit{in.pair.rolling_friction * pressing.size,
                                in.pair.rolling_friction * pressing.rate};
    const Slip roll = rolling_motion(in, radius);
    LawOptions as_point = options;
    as_point.reduced_mass = ReducedMass::point;
    TangentialConstants constants = tangential_constants(in, as_point, roll);
    TangentialForce rolling =
        carried_past<FrictionLaw::cundall_strack>(in, options, constants, &FrictionRecord::rolling, out);
    out.trial.normal = in.geometry.normal;
    out.trial.stiffness = constants.stiffness;
    cap(in, constants);
    stretch(in, roll, constants, rolling);
    out.rolls = cut_off(in, limit, limit, rolling);
    out.trial.rolling = rolling.force;
    out.rolling_energy = stored_energy(rolling.force, constants);
    damp(in, roll, constants, rolling);
    cut_off(in, limit, limit, rolling);
    out.power.rolling = -rolling.force.dot(roll.velocity);
    apply(in, radius, rolling, out);
}

}  // namespace scree
