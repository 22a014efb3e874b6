#pragma once

#include <btBulletCollisionCommon.h>

#include <vector>

#include <scree/mesh/saved_state.hpp>

namespace scree {

void visit_state(auto& with, StateOf<btVector3> auto& vector) {
    with(vector.m_floats[0], vector.m_floats[1], vector.m_floats[2]);
}

/// All that Bullet keeps of a point but its user's pointer.
void visit_state(auto& with, StateOf<btManifoldPoint> auto& p) {
    visit_state(with, p.m_localPointA);
    visit_state(with, p.m_localPointB);
    visit_state(with, p.m_positionWorldOnB);
    visit_state(with, p.m_positionWorldOnA);
    visit_state(with, p.m_normalWorldOnB);
    visit_state(with, p.m_lateralFrictionDir1);
    visit_state(with, p.m_lateralFrictionDir2);
    with(p.m_distance1, p.m_combinedFriction, p.m_combinedRollingFriction, p.m_combinedSpinningFriction,
         p.m_combinedRestitution, p.m_appliedImpulse, p.m_prevRHS, p.m_appliedImpulseLateral1,
         p.m_appliedImpulseLateral2, p.m_contactMotion1, p.m_contactMotion2, p.m_contactCFM, p.m_contactERP,
         p.m_frictionCFM);
    with(p.m_partId0, p.m_partId1, p.m_index0, p.m_index1, p.m_contactPointFlags, p.m_lifeTime);
}

/// In their order, on which Bullet's solver depends.
std::vector<btManifoldPoint> manifold_points(const btPersistentManifold& manifold);
/// Instead of those that are there. Throws StateError for more than a manifold has.
void set_manifold_points(const std::vector<btManifoldPoint>& points, btPersistentManifold& manifold);

}  // namespace scree
