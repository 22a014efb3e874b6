#pragma once

#include <btBulletCollisionCommon.h>

#include <array>
#include <optional>
#include <vector>

#include <scree/mesh/vectors.hpp>

namespace scree {

/// The triangles of an open surface round about, which tell whether a direction of contact is one of the
/// surface or one of an edge that two flat neighbours share and that is no edge of it.
class MeshSurface {
  public:
    /// Those within a box, in the frame of the shape, that is seen from the world at `at`.
    MeshSurface(const btConcaveShape& shape, const btTransform& at, const btVector3& low,
                const btVector3& high);

    using Triangle = std::array<Vec3, 3>;  ///< world frame [m]

    /// The direction of contact at a point of a triangle, given the one that was found there: that one if all
    /// triangles that meet there lie below the plane across it, or else across the triangle. Nothing where it
    /// was found out of the back, which is where the `other` body's centre is not.
    [[nodiscard]] std::optional<Vec3> direction(const Triangle& triangle, const Vec3& point,
                                                const Vec3& found, const Vec3& other) const;

    /// The triangle that a shape is, in the world.
    static Triangle triangle(const btCollisionObjectWrapper& wrap);

  private:
    std::vector<Triangle> triangles_;
};

}  // namespace scree
