#pragma once

#include <algorithm>
#include <span>

#include <scree/contact/built_in_law.hpp>

namespace scree {

/// The built-in law with a bond that grows where bodies were pressed together: it pulls with a strength times
/// the largest patch that the two have shared, and lets go when they part. A law with a history of its own,
/// which gives its derivative.
struct SinteringLaw {
    static constexpr bool gives_rates = true;

    /// What is kept of every accepted step in contact: plain data, so that a checkpoint can hold it.
    struct History {
        double area = 0;  ///< [m²], the largest so far
    };

    double strength = 1e4;  ///< [Pa], of a bond
    BuiltInLaw<LawParts{}> pressing;

    void operator()(const ContactInput& in, std::span<const History> past, ContactForce& out,
                    History& trial) const {
        pressing(in, out);
        const double bonded = past.empty() ? 0 : past.front().area;
        trial.area = std::max(bonded, in.geometry.area);
        if (bonded == 0) {
            return;
        }
        if (out.state == ContactState::open) {
            out = ContactForce{};  // nothing presses, but the bond pulls
            out.state = ContactState::slip;
        }
        // By the committed area: what the step itself adds counts from the next one on.
        const double pull = strength * bonded;
        out.normal_force -= pull;
        out.force -= pull * in.geometry.normal;
        if (in.rates != nullptr) {
            out.force_rate -= pull * in.rates->normal;
        }
    }
};

}  // namespace scree
