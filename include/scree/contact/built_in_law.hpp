#pragma once

#include <scree/contact/friction.hpp>
#include <scree/contact/normal_force.hpp>
#include <scree/contact/patch_friction.hpp>
#include <scree/contact/rolling.hpp>

namespace scree {

/// The project's law: normal force from the overlap volume, friction, torsion, rolling resistance.
template <LawParts parts>
struct BuiltInLaw {
    static constexpr bool gives_rates = true;  ///< in closed form
    static constexpr bool gives_power = true;  ///< see ContactPower
    LawOptions options;                        ///< the same for all pairs

    /// Fills `out` by the law; ContactState::open where the pair is not pressed together and not pulled.
    void operator()(const ContactInput& in, ContactForce& out) const {
        out.reset();
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

    /// Whether the law wants the cells of a pair's patch.
    [[nodiscard]] static bool wants_cells(const PairConstants& pair) {
        return on_cells && pair.torsion && pair.patch_friction && pair.friction > 0;
    }

    /// Whether it wants the potential of contacts that may have one.
    [[nodiscard]] bool wants_potential() const { return options.elasticity == Elasticity::potential; }

  private:
    // Nothing turns about a normal of the plane in which it moves.
    static constexpr bool on_cells = parts.torsion && (parts.friction == FrictionLaw::cundall_strack ||
                                                       parts.friction == FrictionLaw::viscous);

    void add_friction_of(const ContactInput& in, const PressingForce& pressing, ContactForce& out) const {
        if constexpr (on_cells) {
            if (in.cells != nullptr) {
                add_patch_friction<parts.friction>(in, pressing, options, out);
                return;
            }
        }
        if (parts.torsion && in.pair.torsion && in.geometry.lever > 0) {
            add_friction<LawParts{parts.friction, parts.torsion}>(in, pressing, options, out);
        } else {
            add_friction<LawParts{parts.friction, false}>(in, pressing, options, out);
        }
    }
};

}  // namespace scree
