#include <scree/detect/body_shape.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

#include <scree/detect/collision_shapes.hpp>
#include <scree/detect/convert.hpp>

#include "leaf_shape.hpp"

namespace scree {

namespace {

constexpr std::size_t least_kept = 16;

[[noreturn]] void refuse(const btCollisionShape& shape, const std::string& reason) {
    throw std::invalid_argument("shape " + std::string(shape.getName()) + ": " + reason);
}

}  // namespace

BodyShape ShapeLibrary::translate(const btCollisionShape& shape) {
    BodyShape body;
    add_parts(shape, Pose(), body);
    if (body.parts.empty()) {
        refuse(shape, "has no parts");
    }
    return body;
}

void ShapeLibrary::add_parts(const btCollisionShape& shape, const Pose& local, BodyShape& body) {
    if (shape.isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(shape);
        for (int i = 0; i < compound.getNumChildShapes(); ++i) {
            add_parts(*compound.getChildShape(i), local * to_eigen(compound.getChildTransform(i)), body);
        }
        return;
    }
    const auto* polyhedron = dynamic_cast<const PolyhedronShape*>(&shape);
    BodyPart part;
    part.shape = polyhedron != nullptr ? polyhedron->exact() : simple_shape(shape);
    part.local = local * exact_in_leaf(shape);
    part.volume = volume(*part.shape);
    part.bullet = &shape;
    part.bullet_local = local;
    part.skin = polyhedron == nullptr ? leaf_skin(shape) : 0;
    body.skin = std::max(body.skin, part.skin);
    body.open = body.open || std::holds_alternative<OpenSurface>(*part.shape);
    body.volume += part.volume;
    body.radius = std::max(body.radius, local.position.norm() + bounding_radius(*part.shape));
    body.parts.push_back(std::move(part));
}

std::shared_ptr<const Shape> ShapeLibrary::simple_shape(const btCollisionShape& shape) {
    const std::vector<Vec3> numbers = leaf_measures(shape);
    if (numbers.empty()) {
        refuse(
            shape,
            "not done; a hull, box, sphere, capsule, cylinder, cone, plane, mesh or height field that stands "
            "still, or a compound of these is");
    }
    if (!sound_leaf(shape, numbers)) {
        refuse(shape, "sizes must be finite and positive");
    }
    Recipe recipe{static_cast<double>(shape.getShapeType())};
    for (const Vec3& v : numbers) {
        recipe.insert(recipe.end(), v.begin(), v.end());
    }
    std::weak_ptr<const Shape>& known = known_[recipe];
    if (auto shared = known.lock()) {
        return shared;
    }
    std::shared_ptr<const Shape> made;
    try {
        made = std::make_shared<const Shape>(build_leaf(shape, numbers));
    } catch (const std::invalid_argument& error) {
        known_.erase(recipe);
        refuse(shape, error.what());
    }
    known = made;
    drop_unused();
    return made;
}

// Now and then, so that a world whose shapes come and go does not grow.
void ShapeLibrary::drop_unused() {
    if (known_.size() > 2 * std::max(least_kept, kept_)) {
        std::erase_if(known_, [](const auto& entry) { return entry.second.expired(); });
        kept_ = known_.size();
    }
}

}  // namespace scree
