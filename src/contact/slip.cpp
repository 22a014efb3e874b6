#include <scree/contact/carried_force.hpp>

#include "tangential_force.hpp"

namespace scree {

Slip sliding(const ContactInput& in) {
    const Vec3& n = in.geometry.normal;
    const Vec3& v = in.motion.velocity;
    const double approach = v.dot(n);
    Slip slip;
    slip.velocity = v - approach * n;
    if (in.rates != nullptr) {
        slip.rate = in.rates->velocity - approach * in.rates->normal;
        slip.rate.noalias() -= n * (n.transpose() * in.rates->velocity + v.transpose() * in.rates->normal);
    }
    return slip;
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
