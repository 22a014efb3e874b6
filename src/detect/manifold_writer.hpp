#pragma once

#include <btBulletCollisionCommon.h>

#include <span>

#include <scree/overlap/contact_points.hpp>

namespace scree {

/// Makes a manifold hold these points and no others. A point near to one that was there takes its place, with
/// what Bullet's user has attached to it; callbacks come as Bullet's own algorithms make them come. `normal`
/// is the direction of the force on the first body, unit.
void write_points(std::span<const ContactPoint> points, const btVector3& normal,
                  btPersistentManifold& manifold, btManifoldResult& result);

}  // namespace scree
