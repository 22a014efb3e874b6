#include "physical_body.hpp"

#include <cmath>
#include <stdexcept>

#include <scree/detect/convert.hpp>
#include <scree/mesh/mass_properties.hpp>

namespace scree {

namespace {

// Of a body that may not turn, over m ℓ²: large enough to hold it, small enough to compute with.
constexpr double locked_inertia = 1e12;

constexpr double rounding = 1e-14;  // of the weight, in the total force that Bullet adds up

bool may_turn(const btRigidBody& rigid) {
    return !rigid.getAngularFactor().isZero() && !rigid.getInvInertiaDiagLocal().isZero();
}

// The share of momentum per second that a tick's damping takes, as Bullet defines it.
double damping_rate(double damping, double tick) {
    return damping > 0 ? (1 - std::pow(1 - damping, tick)) / tick : 0;
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

Body physical_body(const WorldBody& body) {
    Body physical;
    physical.path = body.path.get();
    if (body.motion != Motion::dynamic) {
        return physical;
    }
    physical.mass = 1 / body.rigid->getInvMass();
    physical.radius = sphere_radius(body.shape.volume);
    if (may_turn(*body.rigid)) {
        physical.inertia = to_eigen(body.rigid->getInvInertiaDiagLocal()).cwiseInverse();
    } else {
        physical.inertia.setConstant(locked_inertia * physical.mass * physical.radius * physical.radius);
    }
    return physical;
}

void read_forces(const btRigidBody& rigid, const BodyState& state, double tick, Body& body) {
    const double slowing = damping_rate(rigid.getLinearDamping(), tick);
    const double turning_down = damping_rate(rigid.getAngularDamping(), tick);
    body.weight = body.mass * to_eigen(rigid.getGravity());
    body.force = to_eigen(rigid.getTotalForce()) - body.weight;
    if (body.force.norm() <= rounding * body.weight.norm()) {
        body.force.setZero();
    }
    body.force -= slowing * state.momentum;
    body.torque = to_eigen(rigid.getTotalTorque()) - turning_down * state.angular_momentum;
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

void check_factors(const btRigidBody& rigid) {
    const Vec3 along = to_eigen(rigid.getLinearFactor());
    const Vec3 around = to_eigen(rigid.getAngularFactor());
    if (along != Vec3::Ones() || (around != Vec3::Ones() && around != Vec3::Zero())) {
        throw std::invalid_argument(
            "linear and angular factors are not done, but for an angular factor of 0");
    }
}

}  // namespace scree
