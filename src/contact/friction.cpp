#include <scree/contact/friction.hpp>

#include "tangential_force.hpp"

namespace scree {

namespace {

template <LawParts parts>
Slip slip_motion(const ContactInput& in) {
    Slip slip = parts.friction == FrictionLaw::cundall_strack_2d ? sliding_in_plane(in) : sliding(in);
    if constexpr (parts.torsion) {
        add_spin(in, slip);
    }
    return slip;
}

// The largest friction: the static one from when a contact sticks until it slips, else the kinetic one.
struct Limits {
    TangentialLimit held, kinetic;

    Limits(const ContactInput& in, bool may_hold, double normal_force, const Row9& normal_force_rate)
        : kinetic{in.pair.kinetic_friction * normal_force, in.pair.kinetic_friction * normal_force_rate} {
        const bool slipping = in.history.age > 0 && in.history.past[0].slipping;
        if (may_hold && !slipping) {
            held = {in.pair.friction * normal_force, in.pair.friction * normal_force_rate};
        } else {
            held = kinetic;
        }
    }
};

// The spring: past, increment and cut-off. What is left is stored.
template <LawParts parts>
TangentialForce spring_force(const ContactInput& in, const LawOptions& options, const Slip& slip,
                             const Limits& limits, TangentialConstants& constants, ContactForce& out) {
    TangentialForce spring = carried_past<parts.friction>(in, options, constants, out);
    out.trial.normal = in.geometry.normal;
    out.trial.stiffness = constants.stiffness;
    cap(in, constants);
    stretch(in, slip, constants, spring);
    out.trial.slipping = cut_off(in, limits.held, limits.kinetic, spring);
    out.state = out.trial.slipping ? ContactState::slip : ContactState::stick;
    out.trial.force = spring.force;
    out.power.tangential = -spring.force.dot(slip.velocity);
    out.tangential_energy =
        constants.stiffness > 0 ? 0.5 * spring.force.squaredNorm() / constants.stiffness : 0;
    return spring;
}

// Takes the vector apart again.
template <LawParts parts>
void apply(const ContactInput& in, const TangentialForce& friction, ContactForce& out) {
    const Vec3& n = in.geometry.normal;
    const double along = friction.force.dot(n);
    out.force += friction.force - along * n;
    if constexpr (parts.torsion) {
        out.moment += in.geometry.lever * along * n;
    }
    if (in.rates == nullptr) {
        return;
    }
    const Row9 along_rate = n.transpose() * friction.rate + friction.force.transpose() * in.rates->normal;
    const Mat39 along_part = n * along_rate + along * in.rates->normal;
    out.force_rate += friction.rate - along_part;
    if constexpr (parts.torsion) {
        out.moment_rate += in.geometry.lever * along_part;
    }
}

}  // namespace

template <LawParts parts>
void add_friction(const ContactInput& in, const Row9& normal_force_rate, const LawOptions& options,
                  ContactForce& out) {
    constexpr bool has_spring = parts.friction != FrictionLaw::viscous;
    const Limits limits(in, has_spring, out.normal_force, normal_force_rate);
    const Slip slip = slip_motion<parts>(in);
    TangentialConstants constants = tangential_constants(in, options, slip);
    TangentialForce friction;
    if constexpr (has_spring) {
        friction = spring_force<parts>(in, options, slip, limits, constants, out);
    } else {
        friction.rate.setZero();
        cap(in, constants);
    }
    damp(in, slip, constants, friction);
    const TangentialLimit& limit = out.trial.slipping ? limits.kinetic : limits.held;
    const bool limited = cut_off(in, limit, limit, friction);
    const double power = -friction.force.dot(slip.velocity);
    if constexpr (has_spring) {
        out.power.tangential_damping = power - out.power.tangential;
    } else {
        out.state = limited ? ContactState::slip : ContactState::stick;
        out.trial.normal = in.geometry.normal;
        // At the limit it is Coulomb's friction.
        (limited ? out.power.tangential : out.power.tangential_damping) = power;
    }
    apply<parts>(in, friction, out);
}

template void add_friction<LawParts{FrictionLaw::cundall_strack, true}>(const ContactInput&, const Row9&,
                                                                        const LawOptions&, ContactForce&);
template void add_friction<LawParts{FrictionLaw::cundall_strack, false}>(const ContactInput&, const Row9&,
                                                                         const LawOptions&, ContactForce&);
template void add_friction<LawParts{FrictionLaw::cundall_strack_2d, true}>(const ContactInput&, const Row9&,
                                                                           const LawOptions&, ContactForce&);
template void add_friction<LawParts{FrictionLaw::cundall_strack_2d, false}>(const ContactInput&, const Row9&,
                                                                            const LawOptions&, ContactForce&);
template void add_friction<LawParts{FrictionLaw::viscous, true}>(const ContactInput&, const Row9&,
                                                                 const LawOptions&, ContactForce&);
template void add_friction<LawParts{FrictionLaw::viscous, false}>(const ContactInput&, const Row9&,
                                                                  const LawOptions&, ContactForce&);

}  // namespace scree
