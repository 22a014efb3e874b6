#pragma once

#include <optional>
#include <vector>

#include <scree/detect/manifold_geometry.hpp>

#include "mesh_surface.hpp"

namespace scree {

/// A point on both surfaces, world frame; the normal is the direction of the force on A.
struct SurfacePoint {
    Vec3 on_a, on_b, normal;

    [[nodiscard]] double distance() const { return normal.dot(on_a - on_b); }  ///< [m], negative: sunk in
};

/// Two parts as Bullet's narrowphase sees them, the bodies at any poses.
struct BulletPair {
    btTransform at_a, at_b;
    btCollisionObjectWrapper a, b;

    BulletPair(const ManifoldGeometry::Side& side_a, const Pose& body_a, const ManifoldGeometry::Side& side_b,
               const Pose& body_b);
    BulletPair(const BulletPair&) = delete;
    BulletPair& operator=(const BulletPair&) = delete;

    void identify(btManifoldResult& result) const;
    /// The one that is an open surface, near the other one; nothing when neither is.
    [[nodiscard]] std::optional<MeshSurface> surface(double reach) const;
};

/// What Bullet's algorithm adds to its manifold, but for directions that no surface has.
class GatheringResult : public btManifoldResult {
  public:
    GatheringResult(const BulletPair& pair, const std::optional<MeshSurface>& surface);
    void addContactPoint(const btVector3& normal_on_b, const btVector3& on_b, btScalar distance) override;

  private:
    const std::optional<MeshSurface>& surface_;
};

/// The points of a manifold between two objects.
std::vector<SurfacePoint> points_of(const btPersistentManifold& manifold, const btCollisionObject& a);

/// Asks Bullet's algorithm for nearest points, for as long as it lives.
class NearestQuery {
  public:
    NearestQuery(btDispatcher& dispatcher, const BulletPair& pair, const std::optional<MeshSurface>& surface,
                 const btDispatcherInfo& info);
    ~NearestQuery();
    NearestQuery(const NearestQuery&) = delete;
    NearestQuery& operator=(const NearestQuery&) = delete;

    /// The nearest points of the two, the nearest of all first, as far as they are within `reach` [m]. Of a
    /// mesh each triangle has its own; what is deeper in a triangle's plane than in the triangle is left out.
    [[nodiscard]] std::vector<SurfacePoint> ask(const BulletPair& pair, double reach);

  private:
    btDispatcher& dispatcher_;
    const std::optional<MeshSurface>& surface_;
    const btDispatcherInfo& info_;
    btCollisionAlgorithm* algorithm_;
};

}  // namespace scree
