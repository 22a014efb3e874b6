#include "manifold_contacts.hpp"

namespace scree {

namespace {

Pose pose_of(const System& system, int body) {
    const BodyState& state = system.states[static_cast<std::size_t>(body)];
    return {state.position, state.orientation};
}

}  // namespace

bool ManifoldContacts::wanted(const BodyPart& a, const BodyPart& b) const {
    return all_ || std::holds_alternative<OpenSurface>(*a.shape) ||
           std::holds_alternative<OpenSurface>(*b.shape);
}

std::shared_ptr<const PairGeometry> ManifoldContacts::make(const ManifoldGeometry::Side& a,
                                                           const ManifoldGeometry::Side& b) {
    const auto geometry = std::make_shared<ManifoldGeometry>(dispatcher_, a, b);
    made_[geometry.get()].geometry = geometry;
    return geometry;
}

void ManifoldContacts::freeze(const btDispatcherInfo& info, const System& system,
                              std::span<const SearchBody> bodies, double time) {
    std::erase_if(made_, [](const auto& entry) { return entry.second.geometry.use_count() == 1; });
    if (made_.empty()) {
        return;
    }
    for (const Contact& contact : system.contacts) {
        const auto found = made_.find(contact.geometry.get());
        if (found == made_.end()) {
            continue;
        }
        Made& made = found->second;
        const SearchBody& a = bodies[static_cast<std::size_t>(contact.a.body)];
        const SearchBody& b = bodies[static_cast<std::size_t>(contact.b.body)];
        const double reach = a.reach + a.skin + b.reach + b.skin;
        if (made.time == time && made.reach >= reach) {
            continue;
        }
        made.time = time;
        made.reach = reach;
        const double area = contact.pair.length * contact.pair.length;
        made.geometry->update({pose_of(system, contact.a.body), pose_of(system, contact.b.body), reach, area},
                              info);
    }
}

void ManifoldContacts::save(const System& system, StateWriter& with) const {
    for (const Contact& contact : system.contacts) {
        if (const auto found = made_.find(contact.geometry.get()); found != made_.end()) {
            found->second.geometry->save(with);
        }
    }
}

void ManifoldContacts::restore(StateReader& with, const btDispatcherInfo& info, const System& system) {
    for (const Contact& contact : system.contacts) {
        if (const auto found = made_.find(contact.geometry.get()); found != made_.end()) {
            found->second.geometry->restore(
                with, {pose_of(system, contact.a.body), pose_of(system, contact.b.body)}, info);
        }
    }
}

void ManifoldContacts::forget(const btCollisionObject& object) {
    std::erase_if(made_, [&](const auto& entry) {
        if (!entry.second.geometry->concerns(object)) {
            return false;
        }
        entry.second.geometry->release();
        return true;
    });
}

btPersistentManifold* ManifoldContacts::manifold(const Contact& contact) const {
    const auto found = made_.find(contact.geometry.get());
    return found == made_.end() ? nullptr : found->second.geometry->manifold();
}

}  // namespace scree
