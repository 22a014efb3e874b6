#pragma once

#include <algorithm>
#include <span>

#include <scree/contact/built_in_law.hpp>

namespace scree {

/// The built-in law with a bond that forms where bodies were pressed together: a suction, the same all over
/// the patch, as far as the patch has been bonded. It lets go when the bodies part. A law with a history of
/// its own, which gives its derivative.
struct SinteringLaw {
    static constexpr bool gives_rates = true;

    /// What is kept of every accepted step in contact: plain data, so that a checkpoint can hold it.
    struct History {
        double area = 0;  ///< [m²], the largest patch so far
    };

    double strength = 1e4;  ///< [Pa], of the bond
    BuiltInLaw<LawParts{}> pressing;

    void operator()(const ContactInput& in, std::span<const History> past, ContactForce& out,
                    History& trial) const {
        pressing(in, out);
        // By the committed area: what the step itself adds counts from the next one on.
        const double bonded = past.empty() ? 0 : past.front().area;
        trial.area = std::max(bonded, in.geometry.area);
        if (bonded == 0 || in.geometry.centre_line) {
            return;
        }
        if (out.state == ContactState::open) {
            out.reset();  // nothing presses, but the bond pulls
            out.state = ContactState::slip;
        }
        pull(in, bonded, out);
    }

  private:
    /// A suction p on A's surface inside B: the force p S and the moment p ∫ r×n_A dA about the centroid.
    void pull(const ContactInput& in, double bonded, ContactForce& out) const {
        const ContactGeometry& g = in.geometry;
        const double suction = strength * std::min(1.0, bonded / g.area);
        out.normal_force -= suction * g.area;
        out.force += suction * g.area_vector;
        out.moment += suction * g.area_moment();
        if (in.rates == nullptr) {
            return;
        }
        // Both integrals change along the boundary and turn with B, the second also with its point c.
        const MotionRates& rates = *in.rates;
        const Mat39 centroid = rates.arm_b + cross_matrix(in.arms.b) * rates.turn_b;
        const Mat39 area = g.boundary.topRows<3>() * rates.xi - cross_matrix(g.area_vector) * rates.turn_b;
        const Mat39 moment = g.boundary.bottomRows<3>() * rates.xi + cross_matrix(g.area_vector) * centroid -
                             cross_matrix(g.area_moment()) * rates.turn_b;
        out.force_rate += suction * area;
        out.moment_rate += suction * moment;
        if (g.area > bonded) {
            const Row9 change = -suction / (g.area * g.area) * g.area_vector.transpose() * area;
            out.force_rate += g.area_vector * change;
            out.moment_rate += g.area_moment() * change;
        }
    }
};

}  // namespace scree
