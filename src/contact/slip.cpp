#include <scree/contact/carried_force.hpp>

#include "tangential_force.hpp"

namespace scree {

namespace {

// The part of a relative velocity across n.
Slip across(const Vec3& n, const Vec3& v, const Mat39* v_rate, const MotionRates* rates) {
    const double along = v.dot(n);
    Slip slip;
    slip.velocity = v - along * n;
    if (rates != nullptr) {
        slip.rate = *v_rate - along * rates->normal;
        slip.rate.noalias() -= n * (n.transpose() * *v_rate + v.transpose() * rates->normal);
    }
    return slip;
}

}  // namespace

Slip sliding(const ContactInput& in) {
    const Mat39* rate = in.rates != nullptr ? &in.rates->velocity : nullptr;
    return across(in.geometry.normal, in.motion.velocity, rate, in.rates);
}

Slip rolling_motion(const ContactInput& in, double radius) {
    const Mat39* rate = in.rates != nullptr ? &in.rates->spin : nullptr;
    Slip roll = across(in.geometry.normal, in.motion.spin, rate, in.rates);
    roll.velocity *= radius;
    if (in.rates != nullptr) {
        roll.rate *= radius;
    }
    return roll;
}

Slip sliding_in_plane(const ContactInput& in) {
    const Vec3 tangent = plane_tangent(in.geometry.normal);
    const Vec3& v = in.motion.velocity;
    Slip slip;
    slip.velocity = v.dot(tangent) * tangent;
    if (in.rates != nullptr) {
        const Mat39 turning = plane_tangent_rate(in.geometry.normal, in.rates->normal);
        slip.rate = v.dot(tangent) * turning;
        slip.rate.noalias() += tangent * (tangent.transpose() * in.rates->velocity + v.transpose() * turning);
    }
    return slip;
}

void add_spin(const ContactInput& in, Slip& slip) {
    const Vec3& n = in.geometry.normal;
    const double spin = in.motion.spin.dot(n);
    slip.lever = in.geometry.lever;
    slip.velocity += slip.lever * spin * n;
    if (in.rates != nullptr) {
        const Row9 spin_rate = n.transpose() * in.rates->spin + in.motion.spin.transpose() * in.rates->normal;
        slip.rate += slip.lever * spin * in.rates->normal;
        slip.rate.noalias() += slip.lever * n * spin_rate;
    }
}

}  // namespace scree
