#include "physical_body.hpp"

#include <cmath>
#include <stdexcept>

#include <LinearMath/btSerializer.h>

#include <scree/detect/convert.hpp>
#include <scree/mesh/mass_properties.hpp>

namespace scree {

namespace {

// Of a body about an axis of its own about which Bullet lets it not turn, over m ℓ²: large enough to hold it,
// small enough to compute with.
constexpr double stiff_inertia = 1e8;
constexpr double free_inertia = 0.4;  // a ball's, of a body that does not turn anyway

constexpr double rounding = 1e-14;  // of the weight, in the total force that Bullet adds up

constexpr double all_of_it = 20;  // lifetimes in a tick, after which nothing is left

// [1/s]: Bullet leaves (1 − damping)ᵗ of a velocity after a time t.
double damping_rate(double damping, double tick) {
    return std::min(-std::log1p(-std::min(damping, 1.0)), all_of_it / tick);
}

Vec3 principal_inertia(const btRigidBody& rigid, double size) {
    const Vec3 inverse = to_eigen(rigid.getInvInertiaDiagLocal());
    if (inverse.isZero(0)) {
        return Vec3::Constant(free_inertia * size);
    }
    return inverse.cwiseMax(1 / (stiff_inertia * size)).cwiseInverse();
}

// What a factor has let through of it.
Vec3 before_factor(const btVector3& seen, const btVector3& factor) {
    Vec3 whole;
    for (int axis = 0; axis < 3; ++axis) {
        whole[axis] = factor[axis] != 0 ? seen[axis] / factor[axis] : 0;
    }
    return whole;
}

}  // namespace

Motion motion_of(const btCollisionObject& object) {
    const auto* rigid = btRigidBody::upcast(&object);
    if (rigid == nullptr || rigid->getActivationState() == DISABLE_SIMULATION) {
        return Motion::fixed;
    }
    if (rigid->isKinematicObject()) {
        return Motion::prescribed;
    }
    return rigid->isStaticObject() || rigid->getInvMass() == 0 ? Motion::fixed : Motion::dynamic;
}

// Bullet tells it to nobody but a serializer.
bool damps_additionally(const btRigidBody& rigid) {
    btDefaultSerializer serializer;
    btRigidBodyDoubleData data{};
    rigid.btRigidBody::serialize(&data, &serializer);
    return data.m_additionalDamping != 0;
}

Body physical_body(const WorldBody& body) {
    Body physical;
    physical.path = body.path.get();
    if (body.motion != Motion::dynamic) {
        return physical;
    }
    physical.mass = 1 / body.rigid->getInvMass();
    physical.radius = sphere_radius(body.shape.volume);
    physical.inertia = principal_inertia(*body.rigid, physical.mass * physical.radius * physical.radius);
    physical.restraint = body.restraint.get();
    return physical;
}

std::shared_ptr<const Restraint> restraint_of(const WorldBody& body, double tick) {
    if (body.motion != Motion::dynamic) {
        return nullptr;
    }
    const btRigidBody& rigid = *body.rigid;
    Restraint restraint;
    restraint.along = to_eigen(rigid.getLinearFactor());
    restraint.around =
        rigid.getInvInertiaDiagLocal().isZero() ? Vec3::Zero() : to_eigen(rigid.getAngularFactor());
    restraint.slowing = damping_rate(rigid.getLinearDamping(), tick);
    restraint.turning_down = damping_rate(rigid.getAngularDamping(), tick);
    return restraint == Restraint() ? nullptr : std::make_shared<const Restraint>(restraint);
}

void read_forces(const btRigidBody& rigid, Body& body) {
    body.weight = body.mass * to_eigen(rigid.getGravity());
    const Vec3 all = before_factor(rigid.getTotalForce(), rigid.getLinearFactor());
    body.force = all - body.weight;
    for (int axis = 0; axis < 3; ++axis) {
        if (rigid.getLinearFactor()[axis] == 0) {
            body.force[axis] = 0;  // nothing is known of it, and nothing comes of it
        }
    }
    if (body.force.norm() <= rounding * body.weight.norm()) {
        body.force.setZero();
    }
    body.torque = before_factor(rigid.getTotalTorque(), rigid.getAngularFactor());
}

void set_velocity(const Body& body, const Vec3& velocity, const Vec3& spin, BodyState& state) {
    if (body.dynamic()) {
        state.momentum = body.mass * velocity;
        state.angular_momentum = world_inertia(body, state.orientation) * spin;
    } else {
        state.momentum = velocity;
        state.angular_momentum = spin;
    }
}

void aim(const Pose& target, double time, BodyState& state) {
    Quat turn = target.orientation * state.orientation.conjugate();
    if (turn.w() < 0) {
        turn.coeffs() = -turn.coeffs();
    }
    const double sine = turn.vec().norm();
    const double angle = 2 * std::atan2(sine, turn.w());
    state.momentum = (target.position - state.position) / time;
    state.angular_momentum = sine > 0 ? Vec3(angle / (sine * time) * turn.vec()) : Vec3::Zero();
}

}  // namespace scree
