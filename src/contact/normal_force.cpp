#include <scree/contact/normal_force.hpp>

#include <cmath>

#include "patch_growth.hpp"

namespace scree {

namespace {

// cn [N s/m³] and, where it varies, its relative change.
struct DampingConstant {
    double value = 0;
    Row9 growth = Row9::Zero();
};

DampingConstant damping_constant(const ContactInput& in, NormalDamping kind) {
    DampingConstant damping{in.pair.normal_damping};
    if (kind == NormalDamping::length && !in.pair.even_damping) {
        return damping;
    }
    // Where S vanishes the overlap's own size stands for it.
    const ContactGeometry& g = in.geometry;
    const double area = g.centre_line ? std::pow(g.volume, 2.0 / 3) : g.area;
    damping.value *= in.pair.length / std::sqrt(area);
    if (in.rates != nullptr) {
        damping.growth =
            g.centre_line ? Row9(in.rates->volume / (-3 * g.volume)) : Row9(-0.5 * patch_growth(in));
    }
    return damping;
}

// The traction cn (n_A·v_rel) n on the patch, its moment about the centroid. The mean of the integrals over
// A's and over B's surface is taken, so that the bodies' order does not matter; they differ by the overlap's
// volume. The derivative follows the motion and leaves the patch's own change out, which is of higher order
// in the overlap.
void add_rocking_damping(const ContactInput& in, double damping, ContactForce& out) {
    const ContactGeometry& g = in.geometry;
    const Mat3 across = -damping * g.tilting * cross_matrix(g.normal);
    const Mat3 by_velocity = across * (g.first_moment - 0.5 * g.volume * Mat3::Identity());
    const Mat3 by_spin = across * g.second_moment;
    out.moment += by_velocity * in.motion.velocity + by_spin * in.motion.spin;
    if (in.rates != nullptr) {
        out.moment_rate.noalias() += by_velocity * in.rates->velocity;
        out.moment_rate.noalias() += by_spin * in.rates->spin;
    }
}

// Elasticity and damping.
bool press(const ContactInput& in, const LawOptions& options, ContactForce& out, PressingForce& pressing) {
    const ContactGeometry& g = in.geometry;
    const double elastic = in.pair.elastic * g.volume;
    const double stored = -elastic * g.normal.dot(in.motion.velocity);
    if (g.depth_moment >= 0) {
        out.normal_energy = in.pair.elastic * g.depth_moment;
    } else {
        out.power.normal_elastic = stored;
    }
    out.power.normal_damping = -stored;  // less the work of the force, below
    const DampingConstant damping = damping_constant(in, options.normal_damping);
    const double damped = damping.value * volume_rate(g, in.motion);
    const double fn = elastic + damped;
    if (!(fn > 0)) {
        return false;
    }
    out.normal_force = pressing.size = fn;
    out.force += fn * g.normal;
    if (in.rates != nullptr) {
        pressing.rate = in.pair.elastic * in.rates->volume + damping.value * in.rates->volume_rate;
        if (options.normal_damping != NormalDamping::length || in.pair.even_damping) {
            pressing.rate += damped * damping.growth;
        }
        out.force_rate.noalias() += g.normal * pressing.rate;
        out.force_rate.noalias() += fn * in.rates->normal;
    }
    if (g.flat_patch && options.damping == DampingPlace::patch) {
        add_rocking_damping(in, damping.value, out);
    }
    out.power.normal = -(out.force.dot(in.motion.velocity) + out.moment.dot(in.motion.spin));
    out.power.normal_damping += out.power.normal;
    return true;
}

// Of ∫ r×n_A dA about the centroid, seen by B and then turned with it.
Mat39 area_moment_rate(const ContactInput& in) {
    const ContactGeometry& g = in.geometry;
    const MotionRates& rates = *in.rates;
    const Mat39 centroid = rates.arm_b + cross_matrix(in.arms.b) * rates.turn_b;
    Mat39 rate = cross_matrix(g.area_vector) * centroid - cross_matrix(g.area_moment()) * rates.turn_b;
    rate.noalias() += g.boundary.bottomRows<3>() * rates.xi;
    return rate;
}

// A suction, the same all over the patch. Where S vanishes it is a force at the centroid.
void pull(const ContactInput& in, ContactForce& out) {
    const ContactGeometry& g = in.geometry;
    const double cohesion = in.pair.cohesion;
    const double suction = g.centre_line ? 0 : cohesion / g.area;
    const Vec3 force = -cohesion * g.normal;
    const Vec3 moment = suction * g.area_moment();
    out.normal_force -= cohesion;
    out.force += force;
    out.moment += moment;
    out.power.cohesion = -(force.dot(in.motion.velocity) + moment.dot(in.motion.spin));
    out.cohesive_energy = -cohesion * g.depth;
    if (in.rates == nullptr) {
        return;
    }
    out.force_rate -= cohesion * in.rates->normal;
    if (suction > 0) {
        out.moment_rate += suction * area_moment_rate(in);
        out.moment_rate.noalias() -= moment * patch_growth(in);
    }
}

}  // namespace

double volume_rate(const ContactGeometry& geometry, const RelativeMotion& motion) {
    return geometry.area_vector.dot(motion.velocity) + geometry.area_moment().dot(motion.spin);
}

bool add_normal_force(const ContactInput& in, const LawOptions& options, ContactForce& out,
                      PressingForce& pressing) {
    const bool pressed = press(in, options, out, pressing);
    if (in.pair.cohesion > 0) {
        pull(in, out);
        return true;
    }
    return pressed;
}

}  // namespace scree
