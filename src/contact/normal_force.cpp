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

// A moment about the centroid, and its rates when they are asked for.
struct Moment {
    Vec3 value;
    Mat39 rate;
};

// The traction cn (n_A·v_rel) n on the patch, its moment about the centroid. The mean of the integrals over
// A's and over B's surface is taken, so that the bodies' order does not matter; they differ by the overlap's
// volume. The derivative follows the motion and leaves the patch's own change out, which is of higher order
// in the overlap.
Moment rocking_damping(const ContactInput& in, double damping) {
    const ContactGeometry& g = in.geometry;
    const Mat3 across = -damping * g.tilting * cross_matrix(g.normal);
    const Mat3 by_velocity = across * (g.first_moment - 0.5 * g.volume * Mat3::Identity());
    const Mat3 by_spin = across * g.second_moment;
    Moment moment;
    moment.value = by_velocity * in.motion.velocity + by_spin * in.motion.spin;
    if (in.rates != nullptr) {
        moment.rate.noalias() = by_velocity * in.rates->velocity;
        moment.rate.noalias() += by_spin * in.rates->spin;
    }
    return moment;
}

// Tractions that nowhere pull and add up to fn have a moment of about fn r̄ at most. Without that bound the
// moment would not vanish with fn, and the force would jump where the contact lets go.
void add_bounded(const Moment& moment, const PressingForce& pressing, double lever, bool with_rates,
                 ContactForce& out) {
    const double size = moment.value.norm();
    const double most = pressing.size * lever;
    if (size <= most) {
        out.moment += moment.value;
        if (with_rates) {
            out.moment_rate += moment.rate;
        }
        return;
    }
    const Vec3 direction = moment.value / size;
    out.moment += most * direction;
    if (with_rates) {
        const Mat39 turned = moment.rate - direction * (direction.transpose() * moment.rate);
        out.moment_rate += most / size * turned;
        out.moment_rate.noalias() += direction * (lever * pressing.rate);
    }
}

// Of a force along a patch and of its moment about the centroid, whose rates are seen by B: then turned with
// it.
struct SurfaceRates {
    Mat39 force, moment;

    SurfaceRates(const ContactInput& in, const Vec3& sum, const Vec3& about, const Mat6& by_xi) {
        const MotionRates& rates = *in.rates;
        const Mat39 centroid = rates.arm_b + cross_matrix(in.arms.b) * rates.turn_b;
        force = by_xi.topRows<3>() * rates.xi;
        force.noalias() -= cross_matrix(sum) * rates.turn_b;
        moment = by_xi.bottomRows<3>() * rates.xi;
        moment.noalias() += cross_matrix(sum) * centroid;
        moment.noalias() -= cross_matrix(about) * rates.turn_b;
    }
};

/// The elastic part, with its derivative.
struct ElasticForce {
    Vec3 force, moment;
    double along = 0;  // n
    Mat39 force_rate, moment_rate;
    Row9 along_rate;
};

// (Y/Lc) V along n.
ElasticForce volume_force(const ContactInput& in) {
    const ContactGeometry& g = in.geometry;
    ElasticForce elastic;
    elastic.along = in.pair.elastic * g.volume;
    elastic.force = elastic.along * g.normal;
    elastic.moment.setZero();
    if (in.rates != nullptr) {
        elastic.along_rate = in.pair.elastic * in.rates->volume;
        elastic.force_rate = elastic.along * in.rates->normal;
        elastic.force_rate.noalias() += g.normal * elastic.along_rate;
        elastic.moment_rate.setZero();
    }
    return elastic;
}

// The gradient of the potential.
ElasticForce potential_force(const ContactInput& in) {
    const DepthPotential& p = *in.potential;
    const Vec3& n = in.geometry.normal;
    ElasticForce elastic;
    elastic.force = in.pair.elastic * p.force;
    elastic.moment = in.pair.elastic * p.moment;
    elastic.along = elastic.force.dot(n);
    if (in.rates != nullptr) {
        const SurfaceRates rates(in, p.force, p.moment, p.rate);
        elastic.force_rate = in.pair.elastic * rates.force;
        elastic.moment_rate = in.pair.elastic * rates.moment;
        elastic.along_rate =
            n.transpose() * elastic.force_rate + elastic.force.transpose() * in.rates->normal;
    }
    return elastic;
}

// What the elastic force stores: its state, where it has a potential, or the power that goes into it.
void store(const ContactInput& in, const ElasticForce& elastic, ContactForce& out) {
    const double stored = -(elastic.force.dot(in.motion.velocity) + elastic.moment.dot(in.motion.spin));
    if (in.potential != nullptr) {
        out.normal_energy = in.pair.elastic * in.potential->value;
    } else if (in.geometry.depth_moment >= 0) {
        out.normal_energy = in.pair.elastic * in.geometry.depth_moment;
    } else {
        out.power.normal_elastic = stored;
    }
    out.power.normal_damping = -stored;  // less the work of the force
}

// Elasticity and damping.
bool press(const ContactInput& in, const LawOptions& options, ContactForce& out, PressingForce& pressing) {
    const ContactGeometry& g = in.geometry;
    const ElasticForce elastic = in.potential != nullptr ? potential_force(in) : volume_force(in);
    store(in, elastic, out);
    const DampingConstant damping = damping_constant(in, options.normal_damping);
    const double damped = damping.value * volume_rate(g, in.motion);
    const double fn = elastic.along + damped;
    if (!(fn > 0)) {
        return false;
    }
    out.normal_force = pressing.size = fn;
    out.force += elastic.force + damped * g.normal;
    out.moment += elastic.moment;
    if (in.rates != nullptr) {
        Row9 damped_rate = damping.value * in.rates->volume_rate;
        if (options.normal_damping != NormalDamping::length || in.pair.even_damping) {
            damped_rate += damped * damping.growth;
        }
        pressing.rate = elastic.along_rate + damped_rate;
        out.force_rate += elastic.force_rate + damped * in.rates->normal;
        out.force_rate.noalias() += g.normal * damped_rate;
        out.moment_rate += elastic.moment_rate;
    }
    if (g.flat_patch && options.damping == DampingPlace::patch) {
        add_bounded(rocking_damping(in, damping.value), pressing, g.lever, in.rates != nullptr, out);
    }
    out.power.normal = -(out.force.dot(in.motion.velocity) + out.moment.dot(in.motion.spin));
    out.power.normal_damping += out.power.normal;
    return true;
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
        out.moment_rate += suction * SurfaceRates(in, g.area_vector, g.area_moment(), g.boundary).moment;
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
