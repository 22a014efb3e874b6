#pragma once

#include <utility>

#include <tests/support/contact_case.hpp>

namespace scree::test {

/// The same contact with the roles of the bodies exchanged.
inline ContactCase seen_from_b(const ContactCase& c) {
    ContactCase other = c;
    other.geometry = exchanged(c.geometry, Vec3::Zero());
    other.motion = {-c.motion.velocity, -c.motion.spin};
    for (FrictionRecord& record : other.history.past) {
        record.force = -record.force;
        record.rolling = -record.rolling;
        record.normal = -record.normal;
    }
    std::swap(other.turn_a, other.turn_b);
    std::swap(other.arms.a, other.arms.b);
    std::swap(other.arms.frame_a, other.arms.frame_b);
    std::swap(other.pair.inverse_inertia_a, other.pair.inverse_inertia_b);
    return other;
}

}  // namespace scree::test
