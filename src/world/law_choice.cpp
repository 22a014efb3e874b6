#include "law_choice.hpp"

namespace scree {

void LawChoice::choose(std::span<const Contact> contacts) {
    bool friction = false;
    bool torsion = false;
    for (const Contact& contact : contacts) {
        friction = friction || contact.pair.friction > 0;
        torsion = torsion || (contact.pair.friction > 0 && contact.pair.torsion);
    }
    if (given_) {
        current_ = given_.get();
    } else if (torsion) {
        current_ = &whole_;
    } else if (friction) {
        current_ = &without_torsion_;
    } else {
        current_ = &frictionless_;
    }
}

}  // namespace scree
