#include <scree/contact/tangential_constants.hpp>

#include <cmath>

#include "patch_growth.hpp"

namespace scree {

namespace {

// The patch's area over Lc², with which the spring grows, and the damper by its root.
void scale_by_patch(const ContactInput& in, TangentialConstants& constants) {
    const double area = in.geometry.area;
    const double share = area / (in.pair.length * in.pair.length);
    constants.stiffness *= share;
    constants.damping *= std::sqrt(share);
    if (in.rates == nullptr || area == 0) {
        return;
    }
    const Row9 growth = patch_growth(in);
    constants.vary = true;
    constants.stiffness_rate = constants.stiffness * growth;
    constants.damping_rate = 0.5 * constants.damping * growth;
}

void use_effective_mass(const ContactInput& in, const Slip& slip, TangentialConstants& constants) {
    const EffectiveMass effective = effective_mass(in, slip);
    const double factor = std::sqrt(effective.mass / in.pair.reduced_mass);
    constants.damping *= factor;
    if (in.rates != nullptr) {
        constants.vary = true;
        constants.damping_rate *= factor;
        constants.damping_rate += 0.5 * constants.damping / effective.mass * effective.rate;
    }
}

// A unit impulse along the slip, seen by one body: its moment, w = r × s_t + r̄ s_n n, and I⁻¹w.
struct Impulse {
    Vec3 moment, spin;

    Impulse(const Vec3& arm, const Quat& frame, const Vec3& inverse_inertia, const Vec3& tangential,
            const Vec3& torsional)
        : moment(arm.cross(tangential) + torsional),
          spin(frame * Vec3(inverse_inertia.cwiseProduct(frame.conjugate() * moment))) {}

    // Derivative of w·I⁻¹w by the body's own motion.
    [[nodiscard]] Row9 rate(const Vec3& tangential, const Mat39& arm_rate, const Mat39& turn) const {
        return 2 * tangential.cross(spin).transpose() * arm_rate + 2 * spin.cross(moment).transpose() * turn;
    }
};

}  // namespace

EffectiveMass effective_mass(const ContactInput& in, const Slip& slip) {
    const double speed = slip.velocity.norm();
    if (speed == 0) {
        return {in.pair.reduced_mass, Row9::Zero()};
    }
    const Vec3& n = in.geometry.normal;
    const Vec3 along = slip.velocity / speed;
    const double turning = along.dot(n);
    const Vec3 tangential = along - turning * n;
    const Vec3 torsional = slip.lever * turning * n;
    const Impulse a(in.arms.a, in.arms.frame_a, in.pair.inverse_inertia_a, tangential, torsional);
    const Impulse b(in.arms.b, in.arms.frame_b, in.pair.inverse_inertia_b, tangential, torsional);
    const double inverse =
        tangential.squaredNorm() / in.pair.reduced_mass + a.moment.dot(a.spin) + b.moment.dot(b.spin);
    EffectiveMass effective{1 / inverse, Row9::Zero()};
    if (in.rates == nullptr) {
        return effective;
    }

    const Vec3 spins = a.spin + b.spin;
    const Vec3 by_tangential =
        2 * (tangential / in.pair.reduced_mass + a.spin.cross(in.arms.a) + b.spin.cross(in.arms.b));
    const double by_turning = 2 * slip.lever * spins.dot(n) - by_tangential.dot(n);
    const Vec3 by_along = by_tangential + by_turning * n;
    const Vec3 by_normal = turning * (2 * slip.lever * spins - by_tangential) + by_turning * along;
    const Vec3 by_slip = (by_along - by_along.dot(along) * along) / speed;
    const Row9 rate = by_slip.transpose() * slip.rate + by_normal.transpose() * in.rates->normal +
                      a.rate(tangential, in.rates->arm_a, in.rates->turn_a) +
                      b.rate(tangential, in.rates->arm_b, in.rates->turn_b);
    effective.rate = -effective.mass * effective.mass * rate;
    return effective;
}

TangentialConstants tangential_constants(const ContactInput& in, const LawOptions& options,
                                         const Slip& slip) {
    TangentialConstants constants;
    constants.stiffness = in.pair.tangential_stiffness;
    constants.damping = in.pair.tangential_damping;
    if (options.tangential_stiffness == TangentialStiffness::patch) {
        scale_by_patch(in, constants);
    } else if (options.tangential_stiffness == TangentialStiffness::no_length) {
        constants.stiffness /= in.pair.length;
    }
    if (options.reduced_mass == ReducedMass::round) {
        const double factor = std::sqrt(in.pair.round_mass / in.pair.reduced_mass);
        constants.damping *= factor;
        constants.damping_rate *= factor;
    } else if (options.reduced_mass == ReducedMass::exact && constants.damping > 0) {
        use_effective_mass(in, slip, constants);
    }
    return constants;
}

}  // namespace scree
