#pragma once

#include <btBulletCollisionCommon.h>

#include <memory>

#include <scree/overlap/shape.hpp>

namespace scree {

/// A convex polyhedron as a Bullet shape: no margin, and the tightest bounds.
class PolyhedronShape : public btConvexHullShape {
  public:
    /// Throws std::invalid_argument when `shape` is not a polyhedron.
    explicit PolyhedronShape(std::shared_ptr<const Shape> shape);

    /// The exact polyhedron, in the frame of the Bullet shape.
    [[nodiscard]] const std::shared_ptr<const Shape>& exact() const { return shape_; }

    /// The least box [m] about the vertices.
    void getAabb(const btTransform& transform, btVector3& low, btVector3& high) const override;
    /// The polyhedron keeps its size: throws std::invalid_argument for any scaling but 1.
    void setLocalScaling(const btVector3& scaling) override;
    /// For Bullet's debugging.
    [[nodiscard]] const char* getName() const override { return "ConvexPolyhedron"; }

  private:
    std::shared_ptr<const Shape> shape_;
};

}  // namespace scree
