#pragma once

#include <cmath>

#include "bodies.hpp"

namespace scree {

/// Equal to nothing that Bullet has: what was last seen of a body that is to be read anew.
inline btVector3 unseen() {
    return {NAN, NAN, NAN};
}

Motion motion_of(const btCollisionObject& object);

/// Whether the body was made with m_additionalDamping, which takes speed from whatever is slow.
bool damps_additionally(const btRigidBody& rigid);

/// Bullet's factors of a dynamic body's axes, and its damping; null when they leave the body free. A body
/// that has no inertia about any axis does not turn. Damping takes its share a second at the same rate all
/// the time; all of it, within a tick [s].
std::shared_ptr<const Restraint> restraint_of(const WorldBody& body, double tick);

/// Mass, inertia and size, without forces.
Body physical_body(const WorldBody& body);

/// The forces from outside: those that were applied, gravity among them. Bullet has multiplied them by its
/// factors already, which is undone here.
void read_forces(const btRigidBody& rigid, Body& body);

/// Sets the momenta of a body that has the given velocities.
void set_velocity(const Body& body, const Vec3& velocity, const Vec3& spin, BodyState& state);

/// Sets the velocities that take a prescribed body to `target` in `time` [s].
void aim(const Pose& target, double time, BodyState& state);

}  // namespace scree
