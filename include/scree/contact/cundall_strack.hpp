#pragma once

#include <scree/contact/friction.hpp>
#include <scree/contact/normal_force.hpp>

namespace scree {

/// Which parts of the built-in law a scene can enter; what is left out is not compiled into its loop.
struct LawParts {
    bool friction = true;
    bool torsion = true;
};

/// The project's law: normal force from the overlap volume, Cundall–Strack friction in three dimensions,
/// torsion.
template <LawParts parts>
struct CundallStrack {
    bool co_rotation =
        true;  ///< turn the stored force with the pair; false: the literal scheme of the source

    void operator()(const ContactInput& in, ContactForce& out) const {
        out = ContactForce{};
        Row9 normal_force_rate = Row9::Zero();
        if (!add_normal_force(in, out, normal_force_rate)) {
            return;
        }
        out.state = ContactState::slip;
        if constexpr (parts.friction) {
            if (in.pair.friction == 0) {
                return;
            }
            if (parts.torsion && in.pair.torsion && in.geometry.lever > 0) {
                add_friction<true>(in, normal_force_rate, co_rotation, out);
            } else {
                add_friction<false>(in, normal_force_rate, co_rotation, out);
            }
        }
    }
};

}  // namespace scree
