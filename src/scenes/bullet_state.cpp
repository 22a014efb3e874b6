// What Bullet's own world carries from one step to the next, out and in.

#include <scree/detect/manifold_points.hpp>

#include "bullet_engine.hpp"

namespace scree {

namespace {

void visit_transform(auto& with, btTransform& transform) {
    visit_state(with, transform.getOrigin());
    for (int row = 0; row < 3; ++row) {
        visit_state(with, transform.getBasis()[row]);
    }
}

using Bodies = std::pair<int, int>;  // a manifold's, by number and in its order

Bodies bodies_of(const btPersistentManifold& manifold) {
    return {manifold.getBody0()->getUserIndex(), manifold.getBody1()->getUserIndex()};
}

/// Those that there are, by their bodies.
std::map<Bodies, btPersistentManifold*> manifolds_of(btDispatcher& dispatcher) {
    std::map<Bodies, btPersistentManifold*> manifolds;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
        manifolds[bodies_of(*manifold)] = manifold;
    }
    return manifolds;
}

}  // namespace

void BulletEngine::save(const Member& member, StateWriter& with) {
    btTransform transform = member.rigid->getWorldTransform();
    btVector3 velocity = member.rigid->getLinearVelocity();
    btVector3 spin = member.rigid->getAngularVelocity();
    visit_transform(with, transform);
    visit_state(with, velocity);
    visit_state(with, spin);
    with(member.orientation);
}

void BulletEngine::restore(StateReader& with, Member& member) {
    btTransform transform;
    btVector3 velocity(0, 0, 0);
    btVector3 spin(0, 0, 0);
    visit_transform(with, transform);
    visit_state(with, velocity);
    visit_state(with, spin);
    with(member.orientation);
    member.rigid->setLinearVelocity(velocity);
    member.rigid->setAngularVelocity(spin);
    member.rigid->setCenterOfMassTransform(transform);
    member.rigid->setInterpolationWorldTransform(transform);
}

// Warm starting makes the points part of the state. A pair without any is as good as new.
void BulletEngine::save(StateWriter& with) const {
    with(report_);
    for (const Member& member : members_) {
        save(member, with);
    }
    std::map<Bodies, std::vector<btManifoldPoint>> points;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
        if (manifold.getNumContacts() > 0) {
            points[bodies_of(manifold)] = manifold_points(manifold);
        }
    }
    with(points.size());
    for (const auto& [bodies, list] : points) {
        with(bodies.first, bodies.second, list);
    }
}

void BulletEngine::restore(StateReader& with) {
    with(report_);
    for (Member& member : members_) {
        restore(with, member);
    }
    restore_manifolds(with);
}

// Bullet finds the pairs and makes their manifolds, whose points are then replaced.
void BulletEngine::restore_manifolds(StateReader& with) {
    world_.performDiscreteCollisionDetection();
    const std::map<Bodies, btPersistentManifold*> manifolds = manifolds_of(dispatcher_);
    for (const auto& [bodies, manifold] : manifolds) {
        manifold->clearManifold();
    }
    std::size_t count = 0;
    with(count);
    for (std::size_t i = 0; i < count; ++i) {
        Bodies bodies;
        std::vector<btManifoldPoint> points;
        with(bodies.first, bodies.second, points);
        const auto found = manifolds.find(bodies);
        StateReader::require(found != manifolds.end());
        set_manifold_points(points, *found->second);
    }
}

}  // namespace scree
