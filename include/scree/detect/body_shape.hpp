#pragma once

#include <btBulletCollisionCommon.h>

#include <map>
#include <memory>
#include <vector>

#include <scree/overlap/shape.hpp>

namespace scree {

/// A convex part of a body.
struct BodyPart {
    std::shared_ptr<const Shape> shape;        ///< exact, shared by equal parts
    Pose local;                                ///< of the shape, in the body's frame
    double volume = 0;                         ///< [m³]; infinite for a half-space and an open surface
    const btCollisionShape* bullet = nullptr;  ///< what it was made from, a leaf; Bullet's user keeps it
    Pose bullet_local;                         ///< of that, in the body's frame
    double skin = 0;  ///< [m], by which Bullet's margin puts its surface outside the exact one
};

/// The exact shape that a Bullet shape stands for.
struct BodyShape {
    std::vector<BodyPart> parts;  ///< at least one
    double volume = 0;            ///< [m³], the parts' sum
    double radius = 0;            ///< [m], of a ball about the body's origin that holds all parts
    double skin = 0;              ///< [m], the largest of the parts'
    bool open = false;            ///< a part is an open surface
};

/// Turns Bullet's shapes into exact ones. Equal parts are made once and shared.
class ShapeLibrary {
  public:
    /// PolyhedronShape gives its polyhedron, btBoxShape the box with its margin, btConvexHullShape the hull
    /// of its points without margin, btConeShape the cone without margin, btSphereShape, btCapsuleShape and
    /// btCylinderShape along any axis, btStaticPlaneShape, and btCompoundShape the parts of its children. A
    /// triangle mesh that stands still and a height field are open surfaces, with Bullet's margin. Throws
    /// std::invalid_argument, naming the shape, for all others and for a hull without volume.
    BodyShape translate(const btCollisionShape& shape);

  private:
    /// What defines a part: Bullet's type number, then sizes or points.
    using Recipe = std::vector<double>;

    void add_parts(const btCollisionShape& shape, const Pose& local, BodyShape& body);
    std::shared_ptr<const Shape> simple_shape(const btCollisionShape& shape);
    void drop_unused();

    std::map<Recipe, std::weak_ptr<const Shape>> known_;
    std::size_t kept_ = 0;  ///< entries after the last clean-up
};

}  // namespace scree
