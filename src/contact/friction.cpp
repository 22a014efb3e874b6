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

    Limits(const ContactInput& in, bool may_hold, const PressingForce& pressing)
        : kinetic{in.pair.kinetic_friction * pressing.size, in.pair.kinetic_friction * pressing.rate} {
        const bool slipping = in.history.age > 0 && in.history.past[0].slipping;
        if (may_hold && !slipping) {
            held = {in.pair.friction * pressing.size, in.pair.friction * pressing.rate};
        } else {
            held = kinetic;
        }
    }
};

// A force and the slip that it works against, taken apart.
struct Parts {
    Vec3 torsional, tangential;
    double torsional_power, tangential_power;

    Parts(const Vec3& force, const Vec3& slip, const Vec3& normal)
        : torsional(force.dot(normal) * normal),
          tangential(force - torsional),
          torsional_power(torsional.dot(slip)),
          tangential_power(tangential.dot(slip)) {}
};

// The spring: past, increment and cut-off. What is left is stored.
template <LawParts parts>
TangentialForce spring_force(const ContactInput& in, const LawOptions& options, const Slip& slip,
                             const Limits& limits, TangentialConstants& constants, ContactForce& out) {
    TangentialForce spring =
        carried_past<parts.friction>(in, options, constants, &FrictionRecord::force, out);
    out.trial.normal = in.geometry.normal;
    out.trial.stiffness = constants.stiffness;
    cap(in, constants);
    stretch(in, slip, constants, spring);
    out.trial.slipping = cut_off(in, limits.held, limits.kinetic, spring);
    out.state = out.trial.slipping ? ContactState::slip : ContactState::stick;
    out.trial.force = spring.force;
    const Parts stored(spring.force, slip.velocity, in.geometry.normal);
    out.power.tangential = -stored.tangential_power;
    out.tangential_energy = stored_energy(stored.tangential, constants);
    out.torsional_energy = stored_energy(stored.torsional, constants);
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

template <LawParts parts>
void add_friction_by(const ContactInput& in, const PressingForce& pressing, const LawOptions& options,
                     const Slip& slip, TangentialConstants& constants, ContactForce& out) {
    constexpr bool has_spring = parts.friction != FrictionLaw::viscous;
    const Limits limits(in, has_spring, pressing);
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
    const Parts acting(friction.force, slip.velocity, in.geometry.normal);
    out.power.torsion = -acting.torsional_power;
    if constexpr (has_spring) {
        out.power.tangential_damping = -acting.tangential_power - out.power.tangential;
    } else {
        out.state = limited ? ContactState::slip : ContactState::stick;
        out.trial.normal = in.geometry.normal;
        // At the limit it is Coulomb's friction.
        (limited ? out.power.tangential : out.power.tangential_damping) = -acting.tangential_power;
    }
    apply<parts>(in, friction, out);
}

}  // namespace

void add_friction_at_point(const ContactInput& in, const PressingForce& pressing, const LawOptions& options,
                           const Slip& slip, TangentialConstants& constants, ContactForce& out) {
    add_friction_by<LawParts{FrictionLaw::cundall_strack, false}>(in, pressing, options, slip, constants,
                                                                  out);
}

template <LawParts parts>
void add_friction(const ContactInput& in, const PressingForce& pressing, const LawOptions& options,
                  ContactForce& out) {
    const Slip slip = slip_motion<parts>(in);
    TangentialConstants constants = tangential_constants(in, options, slip);
    add_friction_by<parts>(in, pressing, options, slip, constants, out);
}

template void add_friction<LawParts{FrictionLaw::cundall_strack, true}>(const ContactInput&,
                                                                        const PressingForce&,
                                                                        const LawOptions&, ContactForce&);
template void add_friction<LawParts{FrictionLaw::cundall_strack, false}>(const ContactInput&,
                                                                         const PressingForce&,
                                                                         const LawOptions&, ContactForce&);
template void add_friction<LawParts{FrictionLaw::cundall_strack_2d, true}>(const ContactInput&,
                                                                           const PressingForce&,
                                                                           const LawOptions&, ContactForce&);
template void add_friction<LawParts{FrictionLaw::cundall_strack_2d, false}>(const ContactInput&,
                                                                            const PressingForce&,
                                                                            const LawOptions&, ContactForce&);
template void add_friction<LawParts{FrictionLaw::viscous, true}>(const ContactInput&, const PressingForce&,
                                                                 const LawOptions&, ContactForce&);
template void add_friction<LawParts{FrictionLaw::viscous, false}>(const ContactInput&, const PressingForce&,
                                                                  const LawOptions&, ContactForce&);

}  // namespace scree
