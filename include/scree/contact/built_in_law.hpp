#pragma once

#include <scree/contact/friction.hpp>
#include <scree/contact/normal_force.hpp>
#include <scree/contact/rolling.hpp>

namespace scree {

/// The project's law: normal force from the overlap volume, friction, torsion, rolling resistance.
template <LawParts parts>
struct BuiltInLaw {
    static constexpr bool gives_rates = true;
    static constexpr bool gives_power = true;
    LawOptions options;

    void operator()(const ContactInput& in, ContactForce& out) const {
        out = ContactForce{};
        PressingForce pressing;
        if (!add_normal_force(in, options, out, pressing)) {
            return;
        }
        out.state = ContactState::slip;
        if constexpr (parts.friction != FrictionLaw::none) {
            if (in.pair.friction > 0) {
                add_friction_of(in, pressing, out);
            }
        }
        if constexpr (parts.rolling) {
            if (in.pair.rolling_friction > 0) {
                add_rolling(in, pressing, options, out);
            }
        }
    }

  private:
    void add_friction_of(const ContactInput& in, const PressingForce& pressing, ContactForce& out) const {
        if (parts.torsion && in.pair.torsion && in.geometry.lever > 0) {
            add_friction<LawParts{parts.friction, parts.torsion}>(in, pressing, options, out);
        } else {
            add_friction<LawParts{parts.friction, false}>(in, pressing, options, out);
        }
    }
};

}  // namespace scree
