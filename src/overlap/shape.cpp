#include <scree/overlap/shape.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct BoundingRadius {
    double operator()(const ConvexPolyhedron& solid) const { return solid.radius; }
    double operator()(const HalfSpace& /*ground*/) const { return infinity; }
    double operator()(const Sphere& sphere) const { return sphere.radius; }
    double operator()(const Frustum& frustum) const { return frustum.facets.radius; }
    double operator()(const Capsule& capsule) const { return capsule.half_length + capsule.radius; }
    double operator()(const OpenSurface& surface) const {
        return surface.low.cwiseAbs().cwiseMax(surface.high.cwiseAbs()).norm();
    }
};

struct ReachAlong {
    const Vec3& direction;

    double operator()(const ConvexPolyhedron& solid) const {
        double reach = -infinity;
        for (const Vec3& vertex : solid.vertices) {
            reach = std::max(reach, direction.dot(vertex));
        }
        return reach;
    }
    double operator()(const HalfSpace& ground) const {
        return direction == ground.normal ? ground.offset : infinity;
    }
    double operator()(const Sphere& sphere) const { return sphere.radius; }
    double operator()(const Frustum& frustum) const {
        const double sideways = direction.head<2>().norm();
        const double height = frustum.half_height * direction.z();
        return std::max(frustum.top * sideways + height, frustum.bottom * sideways - height);
    }
    double operator()(const Capsule& capsule) const {
        return capsule.radius + capsule.half_length * std::abs(direction.z());
    }
    double operator()(const OpenSurface& surface) const {
        return direction.cwiseProduct(surface.low).cwiseMax(direction.cwiseProduct(surface.high)).sum();
    }
};

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

template <class Solid>
Bounds bounds_of(const Solid& solid, const Pose& pose) {
    const Mat3 turn = pose.orientation.toRotationMatrix();
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 along = turn.row(axis);
        box.high[axis] = pose.position[axis] + ReachAlong{along}(solid);
        box.low[axis] = pose.position[axis] - ReachAlong{-along}(solid);
    }
    return box;
}

}  // namespace

double bounding_radius(const Shape& shape) {
    return std::visit(BoundingRadius{}, shape);
}

double reach_along(const Shape& shape, const Vec3& direction) {
    return std::visit(ReachAlong{direction}, shape);
}

Bounds bounds(const Shape& shape, const Pose& pose) {
    return std::visit([&](const auto& solid) { return bounds_of(solid, pose); }, shape);
}

}  // namespace scree
