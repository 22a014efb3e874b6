#include <scree/contact/friction.hpp>

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double least_projection = 1e-6;  // of the stored length, below which it has no direction left

// v × M, column by column.
Mat39 cross(const Vec3& v, const Mat39& m) {
    return cross_matrix(v) * m;
}

// Derivative of turn_about(normal, rotation), the rotation turned further by `turn`.
Row9 turn_about_rate(const Vec3& normal, const Quat& rotation, const Mat39& normal_rate, const Mat39& turn) {
    const double w = rotation.w();
    const Vec3 v = rotation.vec();
    const double along = v.dot(normal);
    const Vec3 by_turn = w * (w * normal + v.cross(normal)) + along * v;
    return (by_turn.transpose() * turn + 2 * w * v.transpose() * normal_rate) / (w * w + along * along);
}

// The relative motion that friction works against: v_t + r̄ ω_n n.
struct Slip {
    Vec3 velocity;
    Mat39 rate;
};

template <bool with_torsion>
Slip slip_motion(const ContactInput& in) {
    const Vec3& n = in.geometry.normal;
    const Vec3& v = in.motion.velocity;
    const double approach = v.dot(n);
    Slip slip;
    slip.velocity = v - approach * n;
    const double spin = in.motion.spin.dot(n);
    if constexpr (with_torsion) {
        slip.velocity += in.geometry.lever * spin * n;
    }
    if (in.rates != nullptr) {
        const MotionRates& rates = *in.rates;
        Row9 along = -(n.transpose() * rates.velocity + v.transpose() * rates.normal);
        double across = -approach;
        if constexpr (with_torsion) {
            along +=
                in.geometry.lever * (n.transpose() * rates.spin + in.motion.spin.transpose() * rates.normal);
            across += in.geometry.lever * spin;
        }
        slip.rate = rates.velocity + across * rates.normal;
        slip.rate.noalias() += n * along;
    }
    return slip;
}

// Scales a force back to the limit; returns true when it had to.
bool cut_off(Vec3& force, Mat39* rate, double limit, const Row9& limit_rate) {
    const double size = force.norm();
    if (!(size > limit)) {
        return false;
    }
    const Vec3 direction = force / size;
    force = limit * direction;
    if (rate != nullptr) {
        const Row9 along = direction.transpose() * *rate;
        *rate = limit / size * (*rate - direction * along) + direction * limit_rate;
    }
    return true;
}

}  // namespace

double turn_about(const Vec3& axis, const Quat& rotation) {
    return 2 * std::atan2(rotation.vec().dot(axis), rotation.w());
}

CarriedForce carry(const FrictionRecord& record, const Vec3& n, const Quat& turn_a, const Quat& turn_b,
                   bool co_rotation, const MotionRates* rates) {
    CarriedForce carried;
    const double torsion = record.force.dot(record.normal);
    const Vec3 stored = record.force - torsion * record.normal;
    const double size = stored.norm();
    const Vec3 projected = stored - stored.dot(n) * n;
    const double left = projected.norm();
    carried.force = torsion * n;
    if (rates != nullptr) {
        carried.rate = torsion * rates->normal;
    }
    carried.lost_direction = size > 0 && left <= least_projection * size;
    if (size == 0 || carried.lost_direction) {
        return carried;
    }

    const double stretch = size / left;
    const Vec3 rescaled = stretch * projected;
    const double angle = co_rotation ? 0.5 * (turn_about(n, turn_a) + turn_about(n, turn_b)) : 0;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const Vec3 sideways = n.cross(rescaled);
    carried.force += cosine * rescaled + sine * sideways;
    if (rates == nullptr) {
        return carried;
    }

    const Vec3 direction = projected / left;
    Mat39 rescaled_rate = -n * (stored.transpose() * rates->normal) - stored.dot(n) * rates->normal;
    rescaled_rate = stretch * (rescaled_rate - direction * (direction.transpose() * rescaled_rate)).eval();
    carried.rate += cosine * rescaled_rate;
    carried.rate += sine * (cross(n, rescaled_rate) - cross(rescaled, rates->normal));
    if (co_rotation) {
        const Row9 angle_rate = 0.5 * (turn_about_rate(n, turn_a, rates->normal, rates->turn_a) +
                                       turn_about_rate(n, turn_b, rates->normal, rates->turn_b));
        carried.rate += (cosine * sideways - sine * rescaled) * angle_rate;
    }
    return carried;
}

template <bool with_torsion>
void add_friction(const ContactInput& in, const Row9& normal_force_rate, bool co_rotation,
                  ContactForce& out) {
    const Vec3& n = in.geometry.normal;
    const double beta_h = in.step.formula.beta_h;
    const double mass = in.pair.reduced_mass;
    const double stiffness = std::min(in.pair.tangential_stiffness, in.step.cap * mass / (beta_h * beta_h));
    const double damping = std::min(in.pair.tangential_damping, in.step.cap * mass / beta_h);
    const double limit = in.pair.friction * out.normal_force;
    const Row9 limit_rate = in.pair.friction * normal_force_rate;
    const bool differentiate = in.rates != nullptr;

    // The increment, Eqs. (5.15) and (5.17), with the past taken as the step's formula has it.
    const Slip slip = slip_motion<with_torsion>(in);
    Vec3 force = -beta_h * stiffness * slip.velocity;
    Mat39 rate;
    if (differentiate) {
        rate = -beta_h * stiffness * slip.rate;
    }
    const std::size_t records = std::min(in.step.formula.past.size(), in.history.age);
    for (std::size_t j = 0; j < records; ++j) {
        const CarriedForce carried =
            carry(in.history.past[j], n, in.step.turn_a[j], in.step.turn_b[j], co_rotation, in.rates);
        force += in.step.formula.past[j] * carried.force;
        if (differentiate) {
            rate += in.step.formula.past[j] * carried.rate;
        }
        out.lost_direction |= carried.lost_direction;
    }

    // Eq. (5.16): this is what is stored. Then the damping, Eq. (5.21), and the second cut-off, Eq. (5.29).
    Mat39* const rate_wanted = differentiate ? &rate : nullptr;
    out.state = cut_off(force, rate_wanted, limit, limit_rate) ? ContactState::slip : ContactState::stick;
    out.trial = {force, n};
    out.power.tangential = -force.dot(slip.velocity);
    out.tangential_energy = stiffness > 0 ? 0.5 * force.squaredNorm() / stiffness : 0;
    force -= damping * slip.velocity;
    if (differentiate) {
        rate -= damping * slip.rate;
    }
    cut_off(force, rate_wanted, limit, limit_rate);
    out.power.tangential_damping = -force.dot(slip.velocity) - out.power.tangential;

    const double along = force.dot(n);
    out.force += force - along * n;
    if constexpr (with_torsion) {
        out.moment += in.geometry.lever * along * n;
    }
    if (!differentiate) {
        return;
    }
    const Row9 along_rate = n.transpose() * rate + force.transpose() * in.rates->normal;
    const Mat39 along_part = n * along_rate + along * in.rates->normal;
    out.force_rate += rate - along_part;
    if constexpr (with_torsion) {
        out.moment_rate += in.geometry.lever * along_part;
    }
}

template void add_friction<true>(const ContactInput&, const Row9&, bool, ContactForce&);
template void add_friction<false>(const ContactInput&, const Row9&, bool, ContactForce&);

}  // namespace scree
