#include <scree/detect/manifold_geometry.hpp>

#include <scree/detect/convert.hpp>
#include <scree/detect/manifold_points.hpp>

#include "bullet_pair.hpp"
#include "expected_points.hpp"
#include "point_choice.hpp"

namespace scree {

namespace {

/// Puts an object to a place for as long as it lives.
class PutAside {
  public:
    PutAside(btCollisionObject& object, const Pose& pose)
        : object_(object), kept_(object.getWorldTransform()) {
        object.setWorldTransform(to_bullet(pose));
    }
    ~PutAside() { object_.setWorldTransform(kept_); }
    PutAside(const PutAside&) = delete;
    PutAside& operator=(const PutAside&) = delete;

  private:
    btCollisionObject& object_;
    btTransform kept_;
};

bool is_ball(const ManifoldGeometry::Side& side) {
    return std::holds_alternative<Sphere>(*side.part.shape);
}

}  // namespace

ManifoldGeometry::ManifoldGeometry(btDispatcher& dispatcher, Side a, Side b)
    : dispatcher_(dispatcher), a_(std::move(a)), b_(std::move(b)) {}

ManifoldGeometry::~ManifoldGeometry() {
    release();
}

void ManifoldGeometry::release() {
    if (algorithm_ != nullptr) {
        algorithm_->~btCollisionAlgorithm();
        dispatcher_.freeCollisionAlgorithm(algorithm_);
        algorithm_ = nullptr;
    }
}

btPersistentManifold* ManifoldGeometry::manifold() {
    found_.resize(0);
    if (algorithm_ != nullptr) {
        algorithm_->getAllContactManifolds(found_);
    }
    return found_.size() > 0 ? found_[0] : nullptr;
}

void ManifoldGeometry::gather(const Situation& now, const btDispatcherInfo& info) {
    const BulletPair pair(a_, now.body_a, b_, now.body_b);
    if (algorithm_ == nullptr) {
        algorithm_ = dispatcher_.findAlgorithm(&pair.a, &pair.b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    }
    const std::optional<MeshSurface> surface = pair.surface(now.reach);
    GatheringResult result(pair, surface);
    algorithm_->processCollision(&pair.a, &pair.b, info, &result);
}

void ManifoldGeometry::update(const Situation& now, const btDispatcherInfo& info) {
    const PutAside put_a(*a_.object, now.body_a);
    const PutAside put_b(*b_.object, now.body_b);
    gather(now, info);
    PointChoice choice(a_, b_, now, points_);
    const btPersistentManifold* found = manifold();
    const bool touching = found != nullptr && found->getNumContacts() > 0;
    if (touching) {
        choice.offer(points_of(*found, *a_.object));
    }
    if (!touching || !(is_ball(a_) || is_ball(b_))) {
        choice.offer(expected_points(dispatcher_, a_, b_, now, info));
    }
    points_.freeze(choice.choose(), now.area, choice.planes());
}

void ManifoldGeometry::save(StateWriter& with) {
    const btPersistentManifold* found = manifold();
    with(found == nullptr ? std::vector<btManifoldPoint>() : manifold_points(*found), points_);
}

// The manifold is Bullet's own to make.
void ManifoldGeometry::restore(StateReader& with, const Situation& now, const btDispatcherInfo& info) {
    const PutAside put_a(*a_.object, now.body_a);
    const PutAside put_b(*b_.object, now.body_b);
    gather(now, info);
    std::vector<btManifoldPoint> points;
    with(points, points_);
    btPersistentManifold* found = manifold();
    StateReader::require(found != nullptr || points.empty());
    if (found != nullptr) {
        set_manifold_points(points, *found);
    }
}

}  // namespace scree
