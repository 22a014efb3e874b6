#pragma once

#include <cmath>

#include "bodies.hpp"

namespace scree {

/// Equal to nothing that Bullet has: what was last seen of a body that is to be read anew.
inline btVector3 unseen() {
    return {NAN, NAN, NAN};
}

Motion motion_of(const btCollisionObject& object);

/// Mass, inertia and size, without forces.
Body physical_body(const WorldBody& body);

/// The forces from outside over a tick [s]: those that were applied, gravity among them, and Bullet's damping
/// as the constant force that takes the same momentum away in a tick.
void read_forces(const btRigidBody& rigid, const BodyState& state, double tick, Body& body);

/// Sets the momenta of a body that has the given velocities.
void set_velocity(const Body& body, const Vec3& velocity, const Vec3& spin, BodyState& state);

/// Sets the velocities that take a prescribed body to `target` in `time` [s].
void aim(const Pose& target, double time, BodyState& state);

/// Throws std::invalid_argument for bodies whose motion is locked along some axes only.
void check_factors(const btRigidBody& rigid);

}  // namespace scree
