#include <scree/detect/collision_shapes.hpp>

#include <stdexcept>

#include <scree/detect/convert.hpp>

namespace scree {

namespace {

const ConvexPolyhedron& polyhedron_of(const std::shared_ptr<const Shape>& shape) {
    const auto* solid = shape ? std::get_if<ConvexPolyhedron>(shape.get()) : nullptr;
    if (solid == nullptr || solid->vertices.empty()) {
        throw std::invalid_argument("a PolyhedronShape needs a polyhedron");
    }
    return *solid;
}

}  // namespace

PolyhedronShape::PolyhedronShape(std::shared_ptr<const Shape> shape)
    : btConvexHullShape(polyhedron_of(shape).vertices.front().data(),
                        static_cast<int>(polyhedron_of(shape).vertices.size()), sizeof(Vec3)),
      shape_(std::move(shape)) {
    btConvexHullShape::setMargin(0);
    recalcLocalAabb();
}

void PolyhedronShape::getAabb(const btTransform& transform, btVector3& low, btVector3& high) const {
    const Bounds box = bounds(*shape_, to_eigen(transform));
    low = to_bullet(box.low);
    high = to_bullet(box.high);
}

void PolyhedronShape::setLocalScaling(const btVector3& scaling) {
    if (to_eigen(scaling) != Vec3::Ones()) {
        throw std::invalid_argument("a PolyhedronShape cannot be scaled: scale its polyhedron");
    }
}

}  // namespace scree
