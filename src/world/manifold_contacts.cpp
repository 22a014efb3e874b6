#include "manifold_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double most_turn = 0.1;    // [rad], while points stay frozen
constexpr double most_slide = 0.2;   // of Lc, of bodies that touch
constexpr double least_span = 1e-4;  // share of the time asked for, however fast a body is
constexpr double push = 0.01;        // of the speed of a fall by Lc, with which what is found deep comes out
constexpr double earth_gravity = 9.81;  // [m/s²]

Pose pose_of(const System& system, int body) {
    const BodyState& state = system.states[static_cast<std::size_t>(body)];
    return {state.position, state.orientation};
}

// Sinking by this much [m] stores what a body needs to move at the push's speed.
double load_growth(const PairConstants& pair, double area) {
    const double speed = push * std::sqrt(earth_gravity * pair.length);
    return speed * std::sqrt(pair.reduced_mass / (pair.elastic * area));
}

bool is_ball(const Contact& contact, int body) {
    const Collider& side = contact.a.body == body ? contact.a : contact.b;
    return std::holds_alternative<Sphere>(*side.shape);
}

double turning(const System& system, const Contact& contact, int body) {
    const auto number = static_cast<std::size_t>(body);
    return is_ball(contact, body) ? 0 : spin(system.bodies[number], system.states[number]).norm();
}

double sliding(const System& system, const Contact& contact) {
    const auto a = static_cast<std::size_t>(contact.a.body);
    const auto b = static_cast<std::size_t>(contact.b.body);
    return (velocity(system.bodies[a], system.states[a]) - velocity(system.bodies[b], system.states[b]))
        .norm();
}

}  // namespace

double ManifoldContacts::most_span(const System& system, double span) const {
    const double least = least_span * span;
    for (const Contact& contact : system.contacts) {
        if (!made_.contains(contact.geometry.get())) {
            continue;
        }
        const double turns =
            turning(system, contact, contact.a.body) + turning(system, contact, contact.b.body);
        const double slides = contact.history.age > 0 ? sliding(system, contact) : 0;
        const double pace = std::max(turns / most_turn, slides / (most_slide * contact.pair.length));
        span = pace * span > 1 ? 1 / pace : span;
    }
    return std::max(span, least);
}

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
        const Pose pose_a = pose_of(system, contact.a.body);
        const Pose pose_b = pose_of(system, contact.b.body);
        made.geometry->update({pose_a, pose_b, reach, area, load_growth(contact.pair, area)}, info);
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
