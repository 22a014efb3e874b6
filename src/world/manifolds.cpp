#include "manifolds.hpp"

#include <functional>
#include <limits>
#include <utility>

#include <scree/detect/convert.hpp>

namespace scree {

namespace {

/// Bullet's own way through its pairs, one after another, whatever the class of the dispatcher.
class NearPairs : public btOverlapCallback {
  public:
    using Left = std::function<bool(const btBroadphasePair&)>;
    NearPairs(btCollisionDispatcher& dispatcher, const btDispatcherInfo& info, Left left_out)
        : dispatcher_(dispatcher), info_(info), left_out_(std::move(left_out)) {}

    bool processOverlap(btBroadphasePair& pair) override {
        if (!left_out_(pair)) {
            dispatcher_.getNearCallback()(pair, dispatcher_, info_);
            ++count_;
        }
        return false;  // the pair stays
    }
    [[nodiscard]] std::size_t count() const { return count_; }

  private:
    btCollisionDispatcher& dispatcher_;
    const btDispatcherInfo& info_;
    Left left_out_;
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

Manifolds::Manifolds(btDispatcher* dispatcher, const ManifoldContacts& contacts)
    : dispatcher_(dynamic_cast<btCollisionDispatcher*>(dispatcher)), contacts_(contacts) {
    use_overlaps(true);
}

void Manifolds::use_overlaps(bool used) {
    overlaps_ = used && dispatcher_ != nullptr ? OverlapDispatch::of(*dispatcher_) : nullptr;
}

void Manifolds::set_on(bool on, btCollisionWorld& world) {
    if (on_ && !on) {
        clear(world);
    }
    on_ = on;
}

void Manifolds::clear(btCollisionWorld& world) {
    btBroadphasePairArray& pairs = world.getPairCache()->getOverlappingPairArray();
    for (int i = 0; i < pairs.size(); ++i) {
        world.getPairCache()->cleanOverlappingPair(pairs[i], world.getDispatcher());
    }
}

void Manifolds::update(btCollisionWorld& world, const Bodies& bodies, const System& system,
                       std::span<const ContactResult> results, double tick) {
    if (!on_) {
        return;
    }
    if (dispatcher_ == nullptr) {
        world.getDispatcher()->dispatchAllCollisionPairs(world.getPairCache(), world.getDispatchInfo(),
                                                         world.getDispatcher());
        return;
    }
    NearPairs near(*dispatcher_, world.getDispatchInfo(),
                   [&](const btBroadphasePair& pair) { return has_manifold(bodies, pair); });
    world.getPairCache()->processAllOverlappingPairs(&near, dispatcher_);
    pairs_ += near.count();
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ContactResult& result = results[i];
        const Contact& contact = system.contacts[i];
        btPersistentManifold* manifold =
            result.touching ? manifold_of(world, contact, bodies, result.point) : nullptr;
        if (manifold != nullptr) {
            const Vec3 friction = result.law.force - result.law.force.dot(result.normal) * result.normal;
            const int first = bodies.number(*manifold->getBody0());
            share_out(*manifold, tick * result.law.normal_force,
                      (first == contact.a.body ? tick : -tick) * friction);
        }
    }
}

bool Manifolds::has_manifold(const Bodies& bodies, const btBroadphasePair& pair) const {
    const auto shape_of = [&](const btBroadphaseProxy& proxy) -> const BodyShape* {
        const int number = bodies.number(*static_cast<const btCollisionObject*>(proxy.m_clientObject));
        return number < 0 ? nullptr : &bodies.all()[static_cast<std::size_t>(number)].shape;
    };
    const BodyShape* a = shape_of(*pair.m_pProxy0);
    const BodyShape* b = shape_of(*pair.m_pProxy1);
    return a != nullptr && b != nullptr && contacts_.wanted(*a, *b);
}

btPersistentManifold* Manifolds::manifold_of(btCollisionWorld& world, const Contact& contact,
                                             const Bodies& bodies, const Vec3& point) {
    if (contact.geometry) {
        return contacts_.manifold(contact);
    }
    const auto handle = [&](int body) {
        return bodies.all()[static_cast<std::size_t>(body)].object->getBroadphaseHandle();
    };
    const btBroadphasePair* pair =
        world.getPairCache()->findPair(handle(contact.a.body), handle(contact.b.body));
    if (pair == nullptr || pair->m_algorithm == nullptr) {
        return nullptr;
    }
    found_.resize(0);
    pair->m_algorithm->getAllContactManifolds(found_);
    return nearest(found_, point);
}

void forget_algorithms(btCollisionWorld& world, btCollisionObject& object) {
    world.getPairCache()->cleanProxyFromPairs(object.getBroadphaseHandle(), world.getDispatcher());
}

}  // namespace scree
