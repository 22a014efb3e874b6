#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scree/contact/carried_force.hpp>
#include <scree/contact/law.hpp>

namespace scree {

/// Elastic spheres of one material, or such a sphere on flat ground: Hertz's normal force with damping, and a
/// tangential spring by Mindlin and Deresiewicz that is cut off at μ fn (Johnson, Contact Mechanics, 4.2 and
/// 7.2; Tsuji, Tanaka and Ishida 1992 for the damping). It gives no derivative, so Newton's method
/// differences it. As one would write it oneself; contact/hertz_mindlin.hpp has the same with its derivative.
struct ElasticSpheres {
    double youngs_modulus = 1e9;  ///< E of the material [Pa]
    double poisson_ratio = 0.3;   ///< ν
    double friction = 0.5;        ///< μ
    double damping = 0;           ///< α, of the normal damping α √(m* k)

    /// E* = E/(2(1 − ν²)) of two alike.
    [[nodiscard]] double effective_modulus() const {
        return youngs_modulus / (2 * (1 - poisson_ratio * poisson_ratio));
    }
    /// G* = G/(2(2 − ν)), G = E/(2(1 + ν)).
    [[nodiscard]] double effective_shear_modulus() const {
        return youngs_modulus / (4 * (1 + poisson_ratio) * (2 - poisson_ratio));
    }

    void operator()(const ContactInput& in, ContactForce& out) const {
        const Vec3& n = in.geometry.normal;
        const double depth = in.geometry.depth;
        // The patch of an overlap of spheres has the area 2π R* δ, where Hertz's own has half of that.
        const double patch = std::sqrt(in.geometry.area / (2 * std::numbers::pi));
        const double stiffness = 2 * effective_modulus() * patch;
        const double closing = -in.motion.velocity.dot(n);
        const double pressing =
            2.0 / 3 * stiffness * depth + damping * std::sqrt(in.pair.reduced_mass * stiffness) * closing;
        if (!(pressing > 0)) {
            return;  // as out is: open, and without force
        }
        out.state = ContactState::stick;
        out.normal_force = pressing;
        out.trial.normal = n;
        out.trial.stiffness = 8 * effective_shear_modulus() * patch;
        out.trial.force = spring(in, out.trial.stiffness);
        const double most = friction * pressing;
        if (const double size = out.trial.force.norm(); size > most) {
            out.trial.force *= most / size;
            out.state = ContactState::slip;
        }
        out.force = pressing * n + out.trial.force;
    }

  private:
    /// What is stored, brought to the present, less the stiffness times the way since. When the patch
    /// shrinks, so does what is stored.
    static Vec3 spring(const ContactInput& in, double stiffness) {
        const std::size_t records = std::min(in.step.formula.past.size(), in.history.age);
        Vec3 force = Vec3::Zero();
        for (std::size_t j = 0; j < records; ++j) {
            const FrictionRecord& record = in.history.past[j];
            const CarriedForce carried =
                carry(record, in.geometry.normal, in.step.turn_a[j], in.step.turn_b[j], true, nullptr);
            force += in.step.formula.past[j] * std::min(1.0, stiffness / record.stiffness) * carried.force;
        }
        const Vec3& v = in.motion.velocity;
        const Vec3& n = in.geometry.normal;
        return force - in.step.formula.beta_h * stiffness * (v - v.dot(n) * n);
    }
};

}  // namespace scree
