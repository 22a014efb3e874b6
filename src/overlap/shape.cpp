#include <scree/overlap/shape.hpp>

#include <limits>

namespace scree {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Bounds bounds_of(const ConvexPolyhedron& solid, const Pose& pose) {
    const Mat3 turn = pose.orientation.toRotationMatrix();
    Bounds box{Vec3::Constant(infinity), Vec3::Constant(-infinity)};
    for (const Vec3& vertex : solid.vertices) {
        const Vec3 point = turn * vertex;
        box.low = box.low.cwiseMin(point);
        box.high = box.high.cwiseMax(point);
    }
    return {box.low + pose.position, box.high + pose.position};
}

Bounds bounds_of(const HalfSpace& half_space, const Pose& pose) {
    Bounds box{Vec3::Constant(-infinity), Vec3::Constant(infinity)};
    const Vec3 normal = pose.orientation * half_space.normal;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 unit = Vec3::Unit(axis);
        const double reach = unit.dot(pose.position) + half_space.offset;
        if (normal == unit) {
            box.high[axis] = reach;
        }
        if (normal == -unit) {
            box.low[axis] = unit.dot(pose.position) - half_space.offset;
        }
    }
    return box;
}

Bounds bounds_of(const Sphere& sphere, const Pose& pose) {
    const Vec3 reach = Vec3::Constant(sphere.radius);
    return {pose.position - reach, pose.position + reach};
}

}  // namespace

double bounding_radius(const Shape& shape) {
    if (const auto* solid = std::get_if<ConvexPolyhedron>(&shape)) {
        return solid->radius;
    }
    if (const auto* sphere = std::get_if<Sphere>(&shape)) {
        return sphere->radius;
    }
    return infinity;
}

Bounds bounds(const Shape& shape, const Pose& pose) {
    return std::visit([&](const auto& solid) { return bounds_of(solid, pose); }, shape);
}

}  // namespace scree
