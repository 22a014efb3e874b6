#include "manifolds.hpp"

#include <limits>

#include <scree/detect/convert.hpp>

namespace scree {

namespace {

/// Bullet's own way through its pairs, one after another, whatever the class of the dispatcher.
class NearPairs : public btOverlapCallback {
  public:
    NearPairs(btCollisionDispatcher& dispatcher, const btDispatcherInfo& info)
        : dispatcher_(dispatcher), info_(info) {}

    bool processOverlap(btBroadphasePair& pair) override {
        dispatcher_.getNearCallback()(pair, dispatcher_, info_);
        ++count_;
        return false;  // the pair stays
    }
    [[nodiscard]] std::size_t count() const { return count_; }

  private:
    btCollisionDispatcher& dispatcher_;
    const btDispatcherInfo& info_;
    std::size_t count_ = 0;
};

Vec3 middle(const btPersistentManifold& manifold) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        sum += to_eigen(manifold.getContactPoint(i).getPositionWorldOnB());
    }
    return sum / manifold.getNumContacts();
}

// Of two bodies of several parts, the manifold where the contact is.
btPersistentManifold* nearest(const btManifoldArray& manifolds, const Vec3& point) {
    btPersistentManifold* found = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < manifolds.size(); ++i) {
        if (manifolds[i]->getNumContacts() == 0) {
            continue;
        }
        const double distance = (middle(*manifolds[i]) - point).squaredNorm();
        if (distance < least) {
            least = distance;
            found = manifolds[i];
        }
    }
    return found;
}

// The points share the impulses in proportion to their depths. `friction` is that on the manifold's first
// body.
void share_out(btPersistentManifold& manifold, double normal, const Vec3& friction) {
    double depths = 0;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        depths -= std::min(0.0, manifold.getContactPoint(i).getDistance());
    }
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint& point = manifold.getContactPoint(i);
        const double share = depths > 0 ? -std::min(0.0, point.getDistance()) / depths : 0;
        point.m_appliedImpulse = share * normal;
        point.m_appliedImpulseLateral1 = share * friction.norm();
        point.m_appliedImpulseLateral2 = 0;
        if (friction.norm() > 0) {
            point.m_lateralFrictionDir1 = to_bullet(friction.normalized());
            point.m_lateralFrictionDir2 = point.m_lateralFrictionDir1.cross(point.m_normalWorldOnB);
        }
    }
}

}  // namespace

Manifolds::Manifolds(btDispatcher* dispatcher)
    : dispatcher_(dynamic_cast<btCollisionDispatcher*>(dispatcher)) {
    if (dispatcher_ != nullptr) {
        overlaps_ = OverlapDispatch::of(*dispatcher_);
    }
}

void Manifolds::set_on(bool on, btCollisionWorld& world) {
    if (on_ && !on) {
        btBroadphasePairArray& pairs = world.getPairCache()->getOverlappingPairArray();
        for (int i = 0; i < pairs.size(); ++i) {
            world.getPairCache()->cleanOverlappingPair(pairs[i], world.getDispatcher());
        }
    }
    on_ = on;
}

void Manifolds::update(btCollisionWorld& world, std::span<const WorldBody> bodies, const System& system,
                       std::span<const ContactResult> results, double tick) {
    if (!on_) {
        return;
    }
    if (dispatcher_ == nullptr) {
        world.getDispatcher()->dispatchAllCollisionPairs(world.getPairCache(), world.getDispatchInfo(),
                                                         world.getDispatcher());
        return;
    }
    NearPairs near(*dispatcher_, world.getDispatchInfo());
    world.getPairCache()->processAllOverlappingPairs(&near, dispatcher_);
    pairs_ += near.count();
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i].touching) {
            note_impulses(world, bodies[static_cast<std::size_t>(system.contacts[i].a.body)],
                          bodies[static_cast<std::size_t>(system.contacts[i].b.body)], results[i], tick);
        }
    }
}

void Manifolds::note_impulses(btCollisionWorld& world, const WorldBody& a, const WorldBody& b,
                              const ContactResult& result, double tick) {
    const btBroadphasePair* pair =
        world.getPairCache()->findPair(a.object->getBroadphaseHandle(), b.object->getBroadphaseHandle());
    if (pair == nullptr || pair->m_algorithm == nullptr) {
        return;
    }
    found_.resize(0);
    pair->m_algorithm->getAllContactManifolds(found_);
    btPersistentManifold* manifold = nearest(found_, result.point);
    if (manifold == nullptr) {
        return;
    }
    const Vec3 friction = result.law.force - result.law.force.dot(result.normal) * result.normal;
    const double sign = manifold->getBody0() == a.object ? 1 : -1;
    share_out(*manifold, tick * result.law.normal_force, sign * tick * friction);
}

void forget_algorithms(btCollisionWorld& world, btCollisionObject& object) {
    world.getPairCache()->cleanProxyFromPairs(object.getBroadphaseHandle(), world.getDispatcher());
}

}  // namespace scree
