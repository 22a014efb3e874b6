#include "bodies.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include <scree/detect/convert.hpp>

#include "physical_body.hpp"

namespace scree {

namespace {

// Equal to nothing that Bullet has, so that it is read.
const btVector3 unseen(NAN, NAN, NAN);

bool same(const btVector3& a, const btVector3& b) {
    return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
}

bool same(const btTransform& a, const btTransform& b) {
    return same(a.getOrigin(), b.getOrigin()) && same(a.getBasis()[0], b.getBasis()[0]) &&
           same(a.getBasis()[1], b.getBasis()[1]) && same(a.getBasis()[2], b.getBasis()[2]);
}

bool same(const Body& a, const Body& b) {
    return a.mass == b.mass && a.inertia == b.inertia && a.radius == b.radius;
}

bool finite(const BodyState& state) {
    return state.position.allFinite() && state.orientation.coeffs().allFinite() &&
           state.momentum.allFinite() && state.angular_momentum.allFinite();
}

}  // namespace

void Bodies::add(btCollisionObject& object) {
    check(object);
    WorldBody body;
    body.object = &object;
    body.rigid = btRigidBody::upcast(&object);
    body.bullet_shape = object.getCollisionShape();
    body.shape = translate(object);
    body.motion = motion_of(object);
    check_motion(body);
    body.transform.setOrigin(unseen);
    body.velocity = body.spin = unseen;

    const Pose pose = to_eigen(object.getWorldTransform());
    numbers_[&object] = static_cast<int>(bodies_.size());
    system_.bodies.push_back(physical_body(body));
    system_.states.push_back({pose.position, pose.orientation});
    bodies_.push_back(std::move(body));
    added_or_removed_ = true;
}

void Bodies::check(const btCollisionObject& object) {
    if (object.getInternalType() & (btCollisionObject::CO_SOFT_BODY | btCollisionObject::CO_HF_FLUID |
                                    btCollisionObject::CO_FEATHERSTONE_LINK)) {
        throw std::invalid_argument("soft bodies, fluids and multibodies are not done");
    }
    if (object.getBroadphaseHandle() != nullptr) {
        throw std::invalid_argument("the body is in a world already");
    }
}

BodyShape Bodies::translate(const btCollisionObject& object) {
    if (object.getCollisionShape() == nullptr) {
        throw std::invalid_argument("a body needs a shape");
    }
    return library_.translate(*object.getCollisionShape());
}

void Bodies::check_motion(const WorldBody& body) {
    if (body.motion == Motion::dynamic && !std::isfinite(body.shape.volume)) {
        throw std::invalid_argument("a plane cannot belong to a body that forces move");
    }
    if (body.rigid != nullptr) {
        check_factors(*body.rigid);
    }
}

void Bodies::remove(const btCollisionObject& object) {
    const auto found = numbers_.find(&object);
    if (found != numbers_.end()) {
        bodies_[static_cast<std::size_t>(found->second)].object = nullptr;
        bodies_[static_cast<std::size_t>(found->second)].rigid = nullptr;
        numbers_.erase(found);
        added_or_removed_ = true;
    }
}

int Bodies::number(const btCollisionObject& object) const {
    const auto found = numbers_.find(&object);
    return found == numbers_.end() ? -1 : found->second;
}

void Bodies::follow_shapes() {
    for (WorldBody& body : bodies_) {
        if (body.object != nullptr && body.object->getCollisionShape() != body.bullet_shape) {
            body.shape = translate(*body.object);
            body.bullet_shape = body.object->getCollisionShape();
            body.contacts_end = true;
        }
    }
}

std::vector<int> Bodies::drop_removed() {
    follow_shapes();
    std::vector<int> new_numbers(bodies_.size(), -1);
    bool changed = false;
    std::size_t kept = 0;
    for (std::size_t old = 0; old < bodies_.size(); ++old) {
        WorldBody& body = bodies_[old];
        changed = changed || body.object == nullptr || body.contacts_end;
        if (body.object == nullptr) {
            continue;
        }
        new_numbers[old] = body.contacts_end ? -1 : static_cast<int>(kept);
        body.contacts_end = false;
        numbers_[body.object] = static_cast<int>(kept);
        if (kept != old) {
            system_.bodies[kept] = system_.bodies[old];
            system_.states[kept] = system_.states[old];
            bodies_[kept] = std::move(body);
        }
        ++kept;
    }
    bodies_.resize(kept);
    system_.bodies.resize(kept);
    system_.states.resize(kept);
    return changed ? new_numbers : std::vector<int>();
}

Changes Bodies::read(double tick, double left) {
    Changes changes{added_or_removed_, added_or_removed_};
    added_or_removed_ = false;
    for (std::size_t number = 0; number < bodies_.size(); ++number) {
        read_one(number, tick, left, changes);
        if (!finite(system_.states[number])) {
            throw std::runtime_error("body " + std::to_string(number) +
                                     " was given a pose or a velocity that is not finite");
        }
    }
    return changes;
}

void Bodies::read_one(std::size_t number, double tick, double left, Changes& changes) {
    WorldBody& body = bodies_[number];
    Body& physical = system_.bodies[number];
    const Motion motion = motion_of(*body.object);
    const bool other_motion = motion != body.motion;
    body.motion = motion;
    check_motion(body);
    const Body now = physical_body(body);
    if (other_motion || !same(physical, now)) {
        physical = now;
        body.velocity = unseen;  // the same velocity is another momentum now
        changes.states = changes.constants = true;
    }
    if (body.friction != body.object->getFriction() || body.restitution != body.object->getRestitution()) {
        body.friction = body.object->getFriction();
        body.restitution = body.object->getRestitution();
        changes.constants = true;
    }
    read_motion(number, left, changes);
    if (motion == Motion::dynamic) {
        read_forces(*body.rigid, system_.states[number], tick, physical);
    }
}

void Bodies::read_motion(std::size_t number, double left, Changes& changes) {
    WorldBody& body = bodies_[number];
    BodyState& state = system_.states[number];
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
        body.velocity = unseen;  // the spin is kept, not the angular momentum
        changes.states = true;
    }
    if (body.motion == Motion::fixed) {
        set_velocity(system_.bodies[number], Vec3::Zero(), Vec3::Zero(), state);
        return;
    }
    const btVector3& velocity = body.rigid->getLinearVelocity();
    const btVector3& spin = body.rigid->getAngularVelocity();
    if (!same(velocity, body.velocity) || !same(spin, body.spin)) {
        set_velocity(system_.bodies[number], to_eigen(velocity), to_eigen(spin), state);
        body.velocity = velocity;
        body.spin = spin;
        changes.states = true;
    }
}

void Bodies::write(bool arrived) {
    for (std::size_t number = 0; number < bodies_.size(); ++number) {
        WorldBody& body = bodies_[number];
        BodyState& state = system_.states[number];
        if (body.motion == Motion::prescribed && arrived) {
            const Pose target = to_eigen(body.object->getWorldTransform());
            state.position = target.position;
            state.orientation = target.orientation;
        }
        if (body.motion != Motion::dynamic) {
            continue;
        }
        const Body& physical = system_.bodies[number];
        body.transform = to_bullet(Pose{state.position, state.orientation});
        body.velocity = to_bullet(velocity(physical, state));
        body.spin = to_bullet(spin(physical, state));
        body.rigid->setLinearVelocity(body.velocity);
        body.rigid->setAngularVelocity(body.spin);
        body.rigid->setCenterOfMassTransform(body.transform);
    }
}

}  // namespace scree
