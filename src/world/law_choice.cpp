#include "law_choice.hpp"

namespace scree {

namespace {

template <LawParts parts>
std::unique_ptr<ContactForces> law_of(const LawOptions& options) {
    return std::make_unique<ForcesOf<BuiltInLaw<parts>>>(BuiltInLaw<parts>{options});
}

template <FrictionLaw friction>
std::unique_ptr<ContactForces> with_friction(LawParts parts, const LawOptions& options) {
    if (parts.torsion) {
        return parts.rolling ? law_of<LawParts{friction, true, true}>(options)
                             : law_of<LawParts{friction, true, false}>(options);
    }
    return parts.rolling ? law_of<LawParts{friction, false, true}>(options)
                         : law_of<LawParts{friction, false, false}>(options);
}

std::unique_ptr<ContactForces> built_in_law(LawParts parts, const LawOptions& options) {
    switch (parts.friction) {
        case FrictionLaw::cundall_strack:
            return with_friction<FrictionLaw::cundall_strack>(parts, options);
        case FrictionLaw::cundall_strack_2d:
            return with_friction<FrictionLaw::cundall_strack_2d>(parts, options);
        case FrictionLaw::viscous:
            return with_friction<FrictionLaw::viscous>(parts, options);
        default:
            return parts.rolling ? law_of<LawParts{FrictionLaw::none, false, true}>(options)
                                 : law_of<LawParts{FrictionLaw::none, false, false}>(options);
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

int LawChoice::add(std::unique_ptr<ContactForces> forces) {
    added_.push_back(std::move(forces));
    return static_cast<int>(added_.size());
}

const ContactForces& LawChoice::of(int law) const {
    if (law > 0 && added_[static_cast<std::size_t>(law - 1)]) {
        return *added_[static_cast<std::size_t>(law - 1)];
    }
    return given_ ? *given_ : *built_in_;
}

// Contacts that follow one another and have the same law, at once.
void LawChoice::evaluate(std::span<const Contact> contacts, std::span<const TrialBody> bodies,
                         const StepFormulas& formulas, Detail detail,
                         std::span<ContactResult> results) const {
    std::size_t begin = 0;
    while (begin < contacts.size()) {
        const int law = contacts[begin].pair.law;
        std::size_t end = added_.empty() ? contacts.size() : begin + 1;
        while (end < contacts.size() && contacts[end].pair.law == law) {
            ++end;
        }
        of(law).evaluate(contacts.subspan(begin, end - begin), bodies, formulas, detail,
                         results.subspan(begin, end - begin));
        begin = end;
    }
}

LawParts LawChoice::needed(std::span<const Contact> contacts) const {
    LawParts parts{FrictionLaw::none, false, false};
    for (const Contact& contact : contacts) {
        if (friction_ != FrictionLaw::none && contact.pair.friction > 0) {
            parts.friction = friction_;
            // Nothing turns about a normal of the plane in which it moves.
            parts.torsion |= may_twist(contact) && friction_ != FrictionLaw::cundall_strack_2d;
        }
        parts.rolling |= contact.pair.rolling_friction > 0;
    }
    return parts;
}

void LawChoice::choose(std::span<const Contact> contacts) {
    const LawParts parts = needed(contacts);
    if (parts != parts_) {
        parts_ = parts;
        built_in_ = built_in_law(parts_, options_);
    }
}

}  // namespace scree
