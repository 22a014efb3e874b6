#include "bullet_pair.hpp"

#include <algorithm>

#include <scree/detect/convert.hpp>

namespace scree {

namespace {

constexpr double ghost =
    1e-3;  // of the reach, by which a point may be deeper in a plane than in its triangle

// The direction of contact, given the normal out of what Bullet has second, which is a triangle's where one
// of the two is a triangle.
std::optional<Vec3> direction(const btManifoldResult& result, const std::optional<MeshSurface>& surface,
                              const Vec3& second, const Vec3& normal) {
    const btCollisionObjectWrapper* wraps[] = {result.getBody0Wrap(), result.getBody1Wrap()};
    for (const int i : {0, 1}) {
        if (surface && wraps[i]->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE) {
            return surface->direction(MeshSurface::triangle(*wraps[i]), second, normal,
                                      to_eigen(wraps[1 - i]->getWorldTransform().getOrigin()));
        }
    }
    return normal;
}

/// Takes all points that an algorithm finds, however far apart the surfaces are.
class Collector : public btManifoldResult {
  public:
    Collector(const BulletPair& pair, const std::optional<MeshSurface>& surface, double reach)
        : btManifoldResult(&pair.a, &pair.b), object_a_(pair.a.getCollisionObject()), surface_(surface) {
        m_closestPointDistanceThreshold = reach;
    }
    void addContactPoint(const btVector3& normal_on_b, const btVector3& on_b, btScalar distance) override {
        if (distance > m_closestPointDistanceThreshold) {
            return;
        }
        const Vec3 second = to_eigen(on_b);
        const Vec3 first = second + distance * to_eigen(normal_on_b);
        const auto normal = direction(*this, surface_, second, to_eigen(normal_on_b));
        if (!normal) {
            return;
        }
        const bool in_order = getPersistentManifold()->getBody0() == object_a_;
        const SurfacePoint point =
            in_order ? SurfacePoint{first, second, *normal} : SurfacePoint{second, first, -*normal};
        if (point.distance() >= std::min(distance, 0.0) - ghost * m_closestPointDistanceThreshold) {
            found_.push_back(point);
        }
    }
    std::vector<SurfacePoint>& found() { return found_; }

  private:
    const btCollisionObject* object_a_;
    const std::optional<MeshSurface>& surface_;
    std::vector<SurfacePoint> found_;
};

}  // namespace

BulletPair::BulletPair(const ManifoldGeometry::Side& side_a, const Pose& body_a,
                       const ManifoldGeometry::Side& side_b, const Pose& body_b)
    : at_a(to_bullet(body_a * side_a.part.bullet_local)),
      at_b(to_bullet(body_b * side_b.part.bullet_local)),
      a(nullptr, side_a.part.bullet, side_a.object, at_a, -1, side_a.index),
      b(nullptr, side_b.part.bullet, side_b.object, at_b, -1, side_b.index) {}

void BulletPair::identify(btManifoldResult& result) const {
    result.setShapeIdentifiersA(-1, a.m_index);
    result.setShapeIdentifiersB(-1, b.m_index);
}

std::optional<MeshSurface> BulletPair::surface(double reach) const {
    const bool a_is_open = a.getCollisionShape()->isConcave();
    const btCollisionObjectWrapper& open = a_is_open ? a : b;
    const btCollisionObjectWrapper& other = a_is_open ? b : a;
    if (!open.getCollisionShape()->isConcave() ||
        open.getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE) {
        return std::nullopt;
    }
    btVector3 low, high;
    other.getCollisionShape()->getAabb(open.getWorldTransform().inverse() * other.getWorldTransform(), low,
                                       high);
    const btVector3 around(reach, reach, reach);
    return MeshSurface(static_cast<const btConcaveShape&>(*open.getCollisionShape()),
                       open.getWorldTransform(), low - around, high + around);
}

GatheringResult::GatheringResult(const BulletPair& pair, const std::optional<MeshSurface>& surface)
    : btManifoldResult(&pair.a, &pair.b), surface_(surface) {
    pair.identify(*this);
}

void GatheringResult::addContactPoint(const btVector3& normal_on_b, const btVector3& on_b,
                                      btScalar distance) {
    const Vec3 second = to_eigen(on_b);
    const Vec3 first = second + distance * to_eigen(normal_on_b);
    if (const auto normal = direction(*this, surface_, second, to_eigen(normal_on_b))) {
        const double along = normal->dot(first - second);
        btManifoldResult::addContactPoint(to_bullet(*normal), to_bullet(first - along * *normal), along);
    }
}

std::vector<SurfacePoint> points_of(const btPersistentManifold& manifold, const btCollisionObject& a) {
    const bool in_order = manifold.getBody0() == &a;
    std::vector<SurfacePoint> points;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        const Vec3 first = to_eigen(point.getPositionWorldOnA());
        const Vec3 second = to_eigen(point.getPositionWorldOnB());
        const Vec3 normal = to_eigen(point.m_normalWorldOnB);
        points.push_back(in_order ? SurfacePoint{first, second, normal}
                                  : SurfacePoint{second, first, -normal});
    }
    return points;
}

NearestQuery::NearestQuery(btDispatcher& dispatcher, const BulletPair& pair,
                           const std::optional<MeshSurface>& surface, const btDispatcherInfo& info)
    : dispatcher_(dispatcher),
      surface_(surface),
      info_(info),
      algorithm_(dispatcher.findAlgorithm(&pair.a, &pair.b, nullptr, BT_CLOSEST_POINT_ALGORITHMS)) {}

NearestQuery::~NearestQuery() {
    algorithm_->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm_);
}

std::vector<SurfacePoint> NearestQuery::ask(const BulletPair& pair, double reach) {
    Collector collector(pair, surface_, reach);
    pair.identify(collector);
    algorithm_->processCollision(&pair.a, &pair.b, info_, &collector);
    std::vector<SurfacePoint>& found = collector.found();
    std::stable_sort(found.begin(), found.end(), [](const SurfacePoint& one, const SurfacePoint& other) {
        return one.distance() < other.distance();
    });
    return std::move(found);
}

}  // namespace scree
