#include "tangential_force.hpp"

namespace scree {

namespace {

// Subtracts factor × slip; `factor_rate` is null where the factor is constant.
void oppose(const ContactInput& in, const Slip& slip, double factor, const Row9* factor_rate,
            TangentialForce& force) {
    force.force -= factor * slip.velocity;
    if (in.rates == nullptr) {
        return;
    }
    force.rate -= factor * slip.rate;
    if (factor_rate != nullptr) {
        force.rate.noalias() -= slip.velocity * *factor_rate;
    }
}

}  // namespace

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

void stretch(const ContactInput& in, const Slip& slip, const TangentialConstants& constants,
             TangentialForce& spring) {
    const double beta_h = in.step.formula.beta_h;
    const Row9 rate = beta_h * constants.stiffness_rate;
    oppose(in, slip, beta_h * constants.stiffness, constants.vary ? &rate : nullptr, spring);
}

void damp(const ContactInput& in, const Slip& slip, const TangentialConstants& constants,
          TangentialForce& force) {
    oppose(in, slip, constants.damping, constants.vary ? &constants.damping_rate : nullptr, force);
}

bool cut_off(const ContactInput& in, const TangentialLimit& most, const TangentialLimit& left,
             TangentialForce& force) {
    const double size = force.force.norm();
    if (!(size > most.force)) {
        return false;
    }
    const Vec3 direction = force.force / size;
    force.force = left.force * direction;
    if (in.rates != nullptr) {
        const Row9 along = direction.transpose() * force.rate;
        force.rate = left.force / size * (force.rate - direction * along) + direction * left.rate;
    }
    return true;
}

double stored_energy(const Vec3& force, const TangentialConstants& constants) {
    return constants.stiffness > 0 ? 0.5 * force.squaredNorm() / constants.stiffness : 0;
}

}  // namespace scree
