#include <scree/overlap/separation.hpp>

#include <algorithm>
#include <limits>

namespace scree {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Width {
    double operator()(const ConvexPolyhedron& solid) const { return solid.width; }
    double operator()(const HalfSpace& /*ground*/) const { return infinity; }
    double operator()(const Sphere& sphere) const { return 2 * sphere.radius; }
    double operator()(const Frustum& frustum) const {
        return 2 * std::min(frustum.half_height, std::max(frustum.bottom, frustum.top));
    }
    double operator()(const Capsule& capsule) const { return 2 * capsule.radius; }
    double operator()(const OpenSurface& /*surface*/) const { return infinity; }
};

// The normal of the face that `point` is farthest above; a shape without faces has none.
bool facing(const Shape& shape, const Pose& pose, const Vec3& point, Vec3& axis) {
    if (const auto* half_space = std::get_if<HalfSpace>(&shape)) {
        axis = pose.orientation * half_space->normal;
        return true;
    }
    const auto* solid = std::get_if<ConvexPolyhedron>(&shape);
    if (solid == nullptr) {
        return false;
    }
    const Vec3 inner = pose.inverse() * point;
    double highest = -infinity;
    const Plane* best = nullptr;
    for (const Plane& plane : solid->planes) {
        const double height = plane.normal.dot(inner) - plane.offset;
        if (height > highest) {
            highest = height;
            best = &plane;
        }
    }
    axis = pose.orientation * best->normal;
    return true;
}

}  // namespace

double support(const Shape& shape, const Pose& pose, const Vec3& direction) {
    constexpr double parallel = 1 - 1e-12;  // to the rounding of a turned normal
    if (const auto* ground = std::get_if<HalfSpace>(&shape)) {
        const bool along = direction.dot(pose.orientation * ground->normal) > parallel;
        return along ? ground->offset + direction.dot(pose.position) : infinity;
    }
    return reach_along(shape, pose.orientation.conjugate() * direction) + direction.dot(pose.position);
}

double width(const Shape& shape) {
    return std::visit(Width{}, shape);
}

Separation separation(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
    Separation best{Vec3::UnitZ(), -infinity};
    const auto consider = [&](const Vec3& axis) {
        const double gap = -support(a, pose_a, -axis) - support(b, pose_b, axis);
        if (gap > best.gap) {
            best = {axis, gap};
        }
    };
    Vec3 axis;
    if (facing(b, pose_b, pose_a.position, axis)) {
        consider(axis);
    }
    if (facing(a, pose_a, pose_b.position, axis)) {
        consider(-axis);
    }
    const Vec3 centres = pose_a.position - pose_b.position;
    if (const double distance = centres.norm(); distance > 0) {
        consider(centres / distance);
    }
    return best;
}

}  // namespace scree
