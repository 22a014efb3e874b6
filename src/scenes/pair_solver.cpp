#include "pair_solver.hpp"

namespace scree {

namespace {

btVector3 in_plane(const btVector3& vector, const btVector3& normal) {
    return vector - vector.dot(normal) * normal;
}

}  // namespace

// The solver works towards v_A − v_B = motion along each direction, where A and B slip no more. Its one
// direction of friction is that of the slip, as it is without a conveyor.
void drive(const btVector3& surface, const btVector3& relative_velocity, btManifoldPoint& point) {
    const btVector3& normal = point.m_normalWorldOnB;
    const btVector3 wanted = -in_plane(surface, normal);
    btVector3 slip = in_plane(relative_velocity, normal) - wanted;
    if (slip.fuzzyZero()) {
        slip =
            wanted.fuzzyZero()
                ? in_plane(normal.absolute().minAxis() == 0 ? btVector3(1, 0, 0) : btVector3(0, 1, 0), normal)
                : wanted;
    }
    point.m_lateralFrictionDir1 = slip.normalized();
    point.m_lateralFrictionDir2 = point.m_lateralFrictionDir1.cross(normal);
    point.m_contactMotion1 = wanted.dot(point.m_lateralFrictionDir1);
    point.m_contactMotion2 = wanted.dot(point.m_lateralFrictionDir2);
    point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
}

}  // namespace scree
