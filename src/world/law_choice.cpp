#include "law_choice.hpp"

namespace scree {

namespace {

template <FrictionLaw friction>
std::unique_ptr<ContactForces> with_friction(bool torsion, const LawOptions& options) {
    using WithTorsion = BuiltInLaw<LawParts{friction, true}>;
    using Without = BuiltInLaw<LawParts{friction, false}>;
    if (torsion) {
        return std::make_unique<ForcesOf<WithTorsion>>(WithTorsion{options});
    }
    return std::make_unique<ForcesOf<Without>>(Without{options});
}

std::unique_ptr<ContactForces> built_in_law(LawParts parts, const LawOptions& options) {
    switch (parts.friction) {
        case FrictionLaw::cundall_strack:
            return with_friction<FrictionLaw::cundall_strack>(parts.torsion, options);
        case FrictionLaw::cundall_strack_2d:
            return with_friction<FrictionLaw::cundall_strack_2d>(parts.torsion, options);
        case FrictionLaw::viscous:
            return with_friction<FrictionLaw::viscous>(parts.torsion, options);
        default:
            return with_friction<FrictionLaw::none>(false, options);
    }
}

bool may_twist(const Contact& contact) {
    const bool smooth =
        std::holds_alternative<Sphere>(*contact.a.shape) || std::holds_alternative<Sphere>(*contact.b.shape);
    return contact.pair.torsion && !smooth;
}

}  // namespace

void LawChoice::set(FrictionLaw friction, const LawOptions& options) {
    given_.reset();
    friction_ = friction;
    options_ = options;
    parts_ = {};
    built_in_ = built_in_law(parts_, options_);
}

LawParts LawChoice::needed(std::span<const Contact> contacts) const {
    LawParts parts{FrictionLaw::none, false};
    for (const Contact& contact : contacts) {
        if (friction_ != FrictionLaw::none && contact.pair.friction > 0) {
            parts.friction = friction_;
            // Nothing turns about a normal of the plane in which it moves.
            parts.torsion |= may_twist(contact) && friction_ != FrictionLaw::cundall_strack_2d;
        }
    }
    return parts;
}

void LawChoice::choose(std::span<const Contact> contacts) {
    const LawParts parts = needed(contacts);
    if (parts.friction != parts_.friction || parts.torsion != parts_.torsion) {
        parts_ = parts;
        built_in_ = built_in_law(parts_, options_);
    }
}

}  // namespace scree
