#include "bodies.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <scree/detect/convert.hpp>

#include "physical_body.hpp"
#include "shape_stamp.hpp"

namespace scree {

void Bodies::add(btCollisionObject& object) {
    check(object);
    WorldBody body;
    body.object = &object;
    body.rigid = btRigidBody::upcast(&object);
    body.bullet_shape = object.getCollisionShape();
    body.shape = translate(object);
    body.shape_stamp = shape_stamp(*body.bullet_shape);
    body.motion = motion_of(object);
    check_motion(body);
    body.restraint = restraint_of(body, 1);
    body.transform.setOrigin(unseen());
    body.velocity = unseen();

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
    const btRigidBody* rigid = btRigidBody::upcast(&object);
    if (rigid != nullptr && damps_additionally(*rigid)) {
        throw std::invalid_argument(
            "additional damping is not done: found m_additionalDamping set, expected linear and angular "
            "damping alone");
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
        throw std::invalid_argument(
            "a plane, a mesh of triangles or a height field cannot belong to a body that forces move");
    }
}

void Bodies::prescribe(int number, std::shared_ptr<const PrescribedPath> path) {
    bodies_[static_cast<std::size_t>(number)].path = std::move(path);
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

bool Bodies::any_open() const {
    return std::any_of(bodies_.begin(), bodies_.end(), [](const WorldBody& body) { return body.shape.open; });
}

void Bodies::follow_shapes() {
    for (WorldBody& body : bodies_) {
        if (body.object == nullptr) {
            continue;
        }
        const btCollisionShape* present = body.object->getCollisionShape();
        const std::uint64_t stamp = present != nullptr ? shape_stamp(*present) : 0;
        if (present != body.bullet_shape || stamp != body.shape_stamp) {
            body.shape_stamp = stamp;
            body.shape = translate(*body.object);
            body.bullet_shape = body.object->getCollisionShape();
            body.contacts_end = true;
            reshaped_.push_back(body.object);
        }
    }
}

std::vector<int> Bodies::drop_removed() {
    follow_shapes();
    const auto ends = [](const WorldBody& body) { return body.object == nullptr || body.contacts_end; };
    if (std::none_of(bodies_.begin(), bodies_.end(), ends)) {
        return {};
    }
    std::vector<int> new_numbers(bodies_.size(), -1);
    std::size_t kept = 0;
    for (std::size_t old = 0; old < bodies_.size(); ++old) {
        WorldBody& body = bodies_[old];
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
    return new_numbers;
}

}  // namespace scree
