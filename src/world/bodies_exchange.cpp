#include <stdexcept>
#include <string>

#include <scree/detect/convert.hpp>

#include "bodies.hpp"
#include "physical_body.hpp"

namespace scree {

namespace {

bool same(const btVector3& a, const btVector3& b) {
    return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
}

bool same(const btTransform& a, const btTransform& b) {
    return same(a.getOrigin(), b.getOrigin()) && same(a.getBasis()[0], b.getBasis()[0]) &&
           same(a.getBasis()[1], b.getBasis()[1]) && same(a.getBasis()[2], b.getBasis()[2]);
}

bool same(const Body& a, const Body& b) {
    return a.mass == b.mass && a.inertia == b.inertia && a.radius == b.radius && a.path == b.path &&
           a.restraint == b.restraint;
}

// A new one has a new address, by which the groups tell.
void renew_restraint(WorldBody& body, double tick) {
    const std::shared_ptr<const Restraint> present = restraint_of(body, tick);
    if ((present == nullptr) != (body.restraint == nullptr) ||
        (present != nullptr && !(*present == *body.restraint))) {
        body.restraint = present;
    }
}

Rest rest_of(int activation) {
    if (activation == DISABLE_DEACTIVATION || gDisableDeactivation) {
        return Rest::never;
    }
    return activation == WANTS_DEACTIVATION ? Rest::wanted : Rest::by_option;
}

bool finite(const BodyState& state) {
    return state.position.allFinite() && state.orientation.coeffs().allFinite() &&
           state.momentum.allFinite() && state.angular_momentum.allFinite();
}

}  // namespace

Changes Bodies::read(double now, double tick, double left) {
    Changes changes;
    changes.any = changes.constants = added_or_removed_;
    added_or_removed_ = false;
    for (std::size_t number = 0; number < bodies_.size(); ++number) {
        read_one(number, now, tick, left, changes);
        if (!finite(system_.states[number])) {
            throw std::runtime_error("body " + std::to_string(number) +
                                     " was given a pose or a velocity that is not finite");
        }
    }
    changes.any = changes.any || !changes.bodies.empty();
    return changes;
}

void Bodies::read_one(std::size_t number, double now, double tick, double left, Changes& changes) {
    WorldBody& body = bodies_[number];
    Body& physical = system_.bodies[number];
    const Motion motion = body.path ? Motion::prescribed : motion_of(*body.object);
    const bool other_motion = motion != body.motion;
    body.motion = motion;
    check_motion(body);
    renew_restraint(body, tick);
    const Body present = physical_body(body);
    if (other_motion || !same(physical, present)) {
        physical = present;
        body.velocity = unseen();  // the same velocity is another momentum now
        changes.bodies.push_back(static_cast<int>(number));
        changes.constants = true;
    }
    if (const SurfaceProperties surface = surface_properties(*body.object); surface != body.surface) {
        body.surface = surface;
        changes.constants = true;
    }
    read_motion(number, now, left, changes);
    if (motion == Motion::dynamic) {
        read_forces(*body.rigid, physical);
        read_activation(number, changes);
    }
}

// What Bullet's user does to a body that rests, or to put it to rest, is seen as a change of its state.
void Bodies::read_activation(std::size_t number, Changes& changes) {
    WorldBody& body = bodies_[number];
    const int activation = body.rigid->getActivationState();
    const bool put_to_rest = activation == ISLAND_SLEEPING && body.activation != ISLAND_SLEEPING;
    const bool woken = activation != ISLAND_SLEEPING && body.activation == ISLAND_SLEEPING;
    if (put_to_rest || woken) {
        changes.bodies.push_back(static_cast<int>(number));
    }
    system_.bodies[number].rest = put_to_rest ? Rest::from_outside : rest_of(activation);
    body.activation = activation;
}

void Bodies::read_motion(std::size_t number, double now, double left, Changes& changes) {
    WorldBody& body = bodies_[number];
    BodyState& state = system_.states[number];
    if (body.path) {
        const PathPoint point = body.path->at(now);
        state = {point.pose.position, point.pose.orientation, point.velocity, point.spin};
        return;
    }
    const btTransform& transform = body.object->getWorldTransform();
    if (body.motion == Motion::prescribed) {
        aim(to_eigen(transform), left, state);
        return;
    }
    if (!same(transform, body.transform)) {
        const Pose pose = to_eigen(transform);
        state.position = pose.position;
        state.orientation = pose.orientation;
        body.transform = transform;
        body.velocity = unseen();  // the spin is kept, not the angular momentum
        changes.bodies.push_back(static_cast<int>(number));
        changes.moved.push_back(static_cast<int>(number));
    }
    if (body.motion == Motion::fixed) {
        set_velocity(system_.bodies[number], Vec3::Zero(), Vec3::Zero(), state);
    } else {
        read_velocities(number, changes);
    }
}

void Bodies::read_velocities(std::size_t number, Changes& changes) {
    WorldBody& body = bodies_[number];
    const btVector3& velocity = body.rigid->getLinearVelocity();
    const btVector3& spin = body.rigid->getAngularVelocity();
    if (!same(velocity, body.velocity) || !same(spin, body.spin)) {
        set_velocity(system_.bodies[number], to_eigen(velocity), to_eigen(spin), system_.states[number]);
        body.velocity = velocity;
        body.spin = spin;
        changes.bodies.push_back(static_cast<int>(number));
    }
}

void Bodies::write(bool arrived, const Groups& groups) {
    for (std::size_t number = 0; number < bodies_.size(); ++number) {
        WorldBody& body = bodies_[number];
        BodyState& state = system_.states[number];
        const bool on_path = body.path != nullptr;
        if (body.motion == Motion::prescribed && !on_path && arrived) {
            const Pose target = to_eigen(body.object->getWorldTransform());
            state.position = target.position;
            state.orientation = target.orientation;
        }
        if (body.motion != Motion::dynamic && !on_path) {
            continue;
        }
        const Body& physical = system_.bodies[number];
        body.transform = to_bullet(Pose{state.position, state.orientation});
        body.velocity = to_bullet(velocity(physical, state));
        body.spin = to_bullet(spin(physical, state));
        body.rigid->setLinearVelocity(body.velocity);
        body.rigid->setAngularVelocity(body.spin);
        body.rigid->setCenterOfMassTransform(body.transform);
        if (body.motion == Motion::dynamic) {
            write_activation(body, groups.asleep(static_cast<int>(number)));
        }
    }
}

void Bodies::write_activation(WorldBody& body, bool asleep) {
    if (asleep) {
        body.rigid->setActivationState(ISLAND_SLEEPING);
    } else if (body.rigid->getActivationState() == ISLAND_SLEEPING) {
        body.rigid->forceActivationState(ACTIVE_TAG);
    }
    body.activation = body.rigid->getActivationState();
}

}  // namespace scree
