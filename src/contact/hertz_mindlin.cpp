#include <scree/contact/hertz_mindlin.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <scree/contact/normal_force.hpp>

#include "patch_growth.hpp"
#include "tangential_force.hpp"

namespace scree {

namespace {

const double damping_factor = 2 * std::sqrt(5.0 / 6);

/// A ball's contact as Hertz sees it.
struct Dent {
    double depth, radius, radius_rate;  // δ, a = √(R*δ) [m], and da/dδ
    double closing;                     // δ̇ [m/s]
    Row9 depth_rate = Row9::Zero();
    Row9 closing_rate = Row9::Zero();

    explicit Dent(const ContactInput& in) : depth(in.geometry.depth) {
        const ContactGeometry& g = in.geometry;
        constexpr double pi = std::numbers::pi;
        radius = std::sqrt(g.volume / (pi * depth) + depth * depth / 3);
        radius_rate =
            (g.area / (pi * depth) - g.volume / (pi * depth * depth) + 2 * depth / 3) / (2 * radius);
        closing = volume_rate(g, in.motion) / g.area;
        if (in.rates != nullptr) {
            depth_rate = in.rates->volume / g.area;
            closing_rate = in.rates->volume_rate / g.area - closing * patch_growth(in);
        }
    }
};

/// A stiffness that grows with the contact's radius, and the dashpot that goes with it.
struct SpringDashpot {
    double stiffness, damping;
    Row9 stiffness_rate = Row9::Zero();
    Row9 damping_rate = Row9::Zero();

    SpringDashpot(const ContactInput& in, const Dent& dent, double by_radius, double ratio)
        : stiffness(by_radius * dent.radius),
          damping(damping_factor * ratio * std::sqrt(stiffness * in.pair.reduced_mass)) {
        if (in.rates != nullptr) {
            const Row9 growth = dent.radius_rate / dent.radius * dent.depth_rate;
            stiffness_rate = stiffness * growth;
            damping_rate = 0.5 * damping * growth;
        }
    }
};

bool press(const ContactInput& in, const Dent& dent, double modulus, double ratio, ContactForce& out,
           PressingForce& pressing) {
    const Vec3& n = in.geometry.normal;
    const SpringDashpot spring(in, dent, 2 * modulus, ratio);
    const double elastic = 2.0 / 3 * spring.stiffness * dent.depth;
    out.power.normal_elastic = elastic * dent.closing;
    out.power.normal_damping = -out.power.normal_elastic;
    const double fn = elastic + spring.damping * dent.closing;
    if (!(fn > 0)) {
        return false;
    }
    out.normal_force = pressing.size = fn;
    out.force = fn * n;
    out.power.normal = fn * dent.closing;
    out.power.normal_damping += out.power.normal;
    if (in.rates != nullptr) {
        pressing.rate = 2.0 / 3 * (spring.stiffness * dent.depth_rate + dent.depth * spring.stiffness_rate) +
                        spring.damping * dent.closing_rate + dent.closing * spring.damping_rate;
        out.force_rate = fn * in.rates->normal;
        out.force_rate.noalias() += n * pressing.rate;
    }
    return true;
}

void rub(const ContactInput& in, const Dent& dent, double modulus, double ratio,
         const PressingForce& pressing, ContactForce& out) {
    const SpringDashpot spring(in, dent, 8 * modulus, ratio);
    TangentialConstants constants{spring.stiffness, spring.damping, in.rates != nullptr,
                                  spring.stiffness_rate, spring.damping_rate};
    add_friction_at_point(in, pressing, LawOptions{}, sliding(in), constants, out);
}

// What is left of the speed of approach, all in units of the elastic contact: the spring is x^(3/2), its
// slope 3/2 √x, and the mass 1.
double rebound(double ratio) {
    constexpr double step = 2e-3;
    const auto force = [&](double x, double v) {
        const double depth = std::max(x, 0.0);
        const double push =
            std::pow(depth, 1.5) + damping_factor * ratio * std::sqrt(1.5 * std::sqrt(depth)) * v;
        return -std::max(push, 0.0);
    };
    double x = 0;
    double v = 1;
    while (x >= 0) {
        // Classical Runge and Kutta.
        const double v1 = v, a1 = force(x, v);
        const double v2 = v + 0.5 * step * a1, a2 = force(x + 0.5 * step * v1, v2);
        const double v3 = v + 0.5 * step * a2, a3 = force(x + 0.5 * step * v2, v3);
        const double v4 = v + step * a3, a4 = force(x + step * v3, v4);
        x += step / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        v += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return -v;
}

}  // namespace

void HertzMindlin::operator()(const ContactInput& in, ContactForce& out) const {
    out.reset();
    const double modulus = in.pair.elastic * in.pair.length;
    const double squeezing = modulus / (2 * (1 - poisson_ratio * poisson_ratio));
    const double shearing = modulus / (4 * (2 - poisson_ratio) * (1 + poisson_ratio));
    const Dent dent(in);
    PressingForce pressing;
    if (!press(in, dent, squeezing, normal_damping, out, pressing)) {
        return;
    }
    out.state = ContactState::slip;
    if (in.pair.friction > 0) {
        rub(in, dent, shearing, tangential_damping, pressing, out);
    }
}

double hertz_damping(double restitution) {
    if (!(restitution > 0 && restitution <= 1)) {
        throw std::invalid_argument("a restitution must be above 0 and at most 1");
    }
    if (restitution == 1) {
        return 0;
    }
    double low = 0;
    double high = 1;
    while (rebound(high) > restitution) {
        high *= 2;
    }
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (rebound(middle) > restitution ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace scree
