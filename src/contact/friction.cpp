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

// Limits the constants as the step asks.
void cap(const ContactInput& in, TangentialConstants& constants) {
    const double beta_h = in.step.formula.beta_h;
    const double most_damping = in.step.cap * in.pair.reduced_mass / beta_h;
    if (constants.stiffness > most_damping / beta_h) {
        constants.stiffness = most_damping / beta_h;
        constants.stiffness_rate.setZero();
    }
    if (constants.damping > most_damping) {
        constants.damping = most_damping;
        constants.damping_rate.setZero();
    }
}

// Subtracts factor × slip.
void oppose(const ContactInput& in, const Slip& slip, double factor, const Row9* factor_rate,
            TangentialForce& friction) {
    friction.force -= factor * slip.velocity;
    if (in.rates == nullptr) {
        return;
    }
    friction.rate -= factor * slip.rate;
    if (factor_rate != nullptr) {
        friction.rate.noalias() -= slip.velocity * *factor_rate;
    }
}

// Scales back to the limit; returns true when it had to.
bool cut_off(const ContactInput& in, const TangentialLimit& limit, TangentialForce& friction) {
    const double size = friction.force.norm();
    if (!(size > limit.force)) {
        return false;
    }
    const Vec3 direction = friction.force / size;
    friction.force = limit.force * direction;
    if (in.rates != nullptr) {
        const Row9 along = direction.transpose() * friction.rate;
        friction.rate = limit.force / size * (friction.rate - direction * along) + direction * limit.rate;
    }
    return true;
}

// The spring: past and increment, Eqs. (5.12), (5.15) and (5.17), then the cut-off, Eq. (5.16). What is left
// is stored.
template <LawParts parts>
TangentialForce stretch(const ContactInput& in, const LawOptions& options, const Slip& slip,
                        const TangentialLimit& limit, TangentialConstants& constants, ContactForce& out) {
    TangentialForce spring = carried_past<parts.friction>(in, options, constants, out);
    out.trial.normal = in.geometry.normal;
    out.trial.stiffness = constants.stiffness;
    cap(in, constants);
    const double beta_h = in.step.formula.beta_h;
    const Row9 rate = beta_h * constants.stiffness_rate;
    oppose(in, slip, beta_h * constants.stiffness, constants.vary ? &rate : nullptr, spring);
    out.state = cut_off(in, limit, spring) ? ContactState::slip : ContactState::stick;
    out.trial.force = spring.force;
    out.power.tangential = -spring.force.dot(slip.velocity);
    out.tangential_energy =
        constants.stiffness > 0 ? 0.5 * spring.force.squaredNorm() / constants.stiffness : 0;
    return spring;
}

// The damping, Eq. (5.21), and the cut-off of all together, Eq. (5.29). Returns true when it was cut.
bool damp(const ContactInput& in, const Slip& slip, const TangentialLimit& limit,
          const TangentialConstants& constants, TangentialForce& friction) {
    oppose(in, slip, constants.damping, constants.vary ? &constants.damping_rate : nullptr, friction);
    return cut_off(in, limit, friction);
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
    const TangentialLimit limit{in.pair.friction * out.normal_force, in.pair.friction * normal_force_rate};
    const Slip slip = slip_motion<parts>(in);
    TangentialConstants constants = tangential_constants(in, options, slip);
    TangentialForce friction;
    if constexpr (parts.friction == FrictionLaw::viscous) {
        cap(in, constants);
        friction.rate.setZero();
        const bool limited = damp(in, slip, limit, constants, friction);
        out.state = limited ? ContactState::slip : ContactState::stick;
        out.trial.normal = in.geometry.normal;
        // At the limit it is Coulomb's friction.
        (limited ? out.power.tangential : out.power.tangential_damping) = -friction.force.dot(slip.velocity);
    } else {
        friction = stretch<parts>(in, options, slip, limit, constants, out);
        damp(in, slip, limit, constants, friction);
        out.power.tangential_damping = -friction.force.dot(slip.velocity) - out.power.tangential;
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
