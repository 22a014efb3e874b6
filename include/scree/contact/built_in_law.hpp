#pragma once

#include <scree/contact/friction.hpp>
#include <scree/contact/normal_force.hpp>

namespace scree {

/// The project's law: normal force from the overlap volume, friction, torsion.
template <LawParts parts>
struct BuiltInLaw {
    static constexpr bool gives_rates = true;
    static constexpr bool gives_power = true;
    LawOptions options;

    void operator()(const ContactInput& in, ContactForce& out) const {
        out = ContactForce{};
        Row9 normal_force_rate = Row9::Zero();
        if (!add_normal_force(in, options, out, normal_force_rate)) {
            return;
        }
        out.state = ContactState::slip;
        if constexpr (parts.friction != FrictionLaw::none) {
            if (in.pair.friction == 0) {
                return;
            }
            if (parts.torsion && in.pair.torsion && in.geometry.lever > 0) {
                add_friction<LawParts{parts.friction, parts.torsion}>(in, normal_force_rate, options, out);
            } else {
                add_friction<LawParts{parts.friction, false}>(in, normal_force_rate, options, out);
            }
        }
    }
};

}  // namespace scree
