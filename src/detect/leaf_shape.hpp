#pragma once

#include <btBulletCollisionCommon.h>

#include <vector>

#include <scree/overlap/shape.hpp>

namespace scree {

/// Points and sizes of a shape that is no compound, as Bullet has them, scaling included. Empty: one that is
/// not done.
std::vector<Vec3> leaf_measures(const btCollisionShape& shape);

/// Whether these are finite and, where they must be, positive.
bool sound_leaf(const btCollisionShape& shape, const std::vector<Vec3>& measures);

/// The exact shape of them. Throws std::invalid_argument for points that have no hull.
Shape build_leaf(const btCollisionShape& shape, const std::vector<Vec3>& measures);

/// The exact shape's frame, seen from Bullet's: solids of revolution have their z axis along Bullet's own.
Pose exact_in_leaf(const btCollisionShape& shape);

/// By how much [m] Bullet's margin puts the surface outside the exact one.
double leaf_skin(const btCollisionShape& shape);

/// [m³]; infinite for a half-space and an open surface.
double volume(const Shape& shape);

}  // namespace scree
