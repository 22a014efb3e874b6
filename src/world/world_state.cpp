// What a world carries from one tick to the next, out and in.

#include <algorithm>

#include "world_implementation.hpp"

namespace scree {

// Before the first tick there is nothing yet.
void WorldImplementation::save(StateWriter& with) const {
    with(report_.ticks);
    if (report_.ticks == 0) {
        return;
    }
    visit_state(with, *this);
    for (const Contact& contact : system_.contacts) {
        with(contact.history);
    }
    manifold_contacts_.save(system_, with);
    groups_.save(with);
}

// The bodies are read as at the start of a first tick, so that nothing new is seen in them at the next.
void WorldImplementation::restore(StateReader& with, btCollisionWorld& world, double gravity) {
    constexpr double tick = 1;  // [s]; nothing of it stays
    std::size_t ticks = 0;
    with(ticks);
    if (ticks == 0) {
        return;
    }
    read_bodies(tick);
    prepare(gravity);
    visit_state(with, *this);
    StateReader::require(possible(list_.pairs()));
    list_.remake([this](const PartPair& pair) { return make_contact(pair); });
    for (Contact& contact : system_.contacts) {
        with(contact.history);
    }
    manifold_contacts_.restore(with, world.getDispatchInfo(), system_);
    groups_.restore(with, clock_.now());
    bodies_.write(false, groups_);
    changed_ = false;
}

bool WorldImplementation::possible(std::span<const PartPair> pairs) const {
    const auto parts = [&](int body) {
        return static_cast<int>(bodies_.all()[static_cast<std::size_t>(body)].shape.parts.size());
    };
    const auto count = static_cast<int>(bodies_.all().size());
    const auto good = [&](const PartPair& pair) {
        return 0 <= pair.body_a && pair.body_a < pair.body_b && pair.body_b < count && 0 <= pair.part_a &&
               pair.part_a < parts(pair.body_a) && 0 <= pair.part_b && pair.part_b < parts(pair.body_b) &&
               (system_.bodies[static_cast<std::size_t>(pair.body_a)].dynamic() ||
                system_.bodies[static_cast<std::size_t>(pair.body_b)].dynamic());
    };
    return std::all_of(pairs.begin(), pairs.end(), good) && std::is_sorted(pairs.begin(), pairs.end());
}

}  // namespace scree
