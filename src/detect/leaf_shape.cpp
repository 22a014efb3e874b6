#include "leaf_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <scree/detect/convert.hpp>
#include <scree/mesh/convex_hull.hpp>
#include <scree/mesh/mass_properties.hpp>

namespace scree {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Volume {
    double operator()(const ConvexPolyhedron& solid) const { return mass_properties(solid).volume; }
    double operator()(const HalfSpace& /*ground*/) const { return infinity; }
    double operator()(const OpenSurface& /*surface*/) const { return infinity; }
    double operator()(const Sphere& sphere) const { return 4.0 / 3.0 * pi * std::pow(sphere.radius, 3); }
    double operator()(const Frustum& frustum) const {
        const double squares =
            frustum.bottom * frustum.bottom + frustum.bottom * frustum.top + frustum.top * frustum.top;
        return 2.0 / 3.0 * pi * frustum.half_height * squares;
    }
    double operator()(const Capsule& capsule) const {
        const double square = capsule.radius * capsule.radius;
        return pi * square * (4.0 / 3.0 * capsule.radius + 2 * capsule.half_length);
    }
};

/// What capsules, cylinders and cones have in common.
struct RoundSizes {
    int axis = -1;           // of Bullet's three, −1 for all other shapes
    double radius = 0;       // [m], of a cone's base
    double half_height = 0;  // [m], of a capsule without its round ends

    explicit RoundSizes(const btCollisionShape& shape) {
        if (shape.getShapeType() == CAPSULE_SHAPE_PROXYTYPE) {
            const auto& capsule = static_cast<const btCapsuleShape&>(shape);
            *this = {capsule.getUpAxis(), capsule.getRadius(), capsule.getHalfHeight()};
        } else if (shape.getShapeType() == CYLINDER_SHAPE_PROXYTYPE) {
            const auto& cylinder = static_cast<const btCylinderShape&>(shape);
            const int up = cylinder.getUpAxis();
            *this = {up, cylinder.getRadius(), cylinder.getHalfExtentsWithMargin()[up]};
        } else if (shape.getShapeType() == CONE_SHAPE_PROXYTYPE) {
            const auto& cone = static_cast<const btConeShape&>(shape);
            *this = {cone.getConeUpIndex(), cone.getRadius(), 0.5 * cone.getHeight()};
        }
    }
    /// From a frame with the z axis along the solid's to Bullet's.
    [[nodiscard]] Pose turn() const {
        return axis < 0 ? Pose() : Pose{Vec3::Zero(), Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::Unit(axis))};
    }

  private:
    RoundSizes(int up, double r, double h) : axis(up), radius(r), half_height(h) {}
};

bool is_open_surface(const btCollisionShape& shape) {
    const int type = shape.getShapeType();
    return type == TRIANGLE_MESH_SHAPE_PROXYTYPE || type == SCALED_TRIANGLE_MESH_SHAPE_PROXYTYPE ||
           type == TERRAIN_SHAPE_PROXYTYPE;
}

}  // namespace

double leaf_skin(const btCollisionShape& shape) {
    const int type = shape.getShapeType();
    return type == CONVEX_HULL_SHAPE_PROXYTYPE || type == CONE_SHAPE_PROXYTYPE ? shape.getMargin() : 0;
}

std::vector<Vec3> leaf_measures(const btCollisionShape& shape) {
    std::vector<Vec3> numbers;
    if (shape.getShapeType() == BOX_SHAPE_PROXYTYPE) {
        numbers.push_back(2 * to_eigen(static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin()));
    } else if (shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE) {
        const auto& hull = static_cast<const btConvexHullShape&>(shape);
        for (int i = 0; i < hull.getNumPoints(); ++i) {
            numbers.push_back(to_eigen(hull.getScaledPoint(i)));
        }
    } else if (shape.getShapeType() == SPHERE_SHAPE_PROXYTYPE) {
        numbers.emplace_back(static_cast<const btSphereShape&>(shape).getRadius(), 0, 0);
    } else if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) {
        const auto& plane = static_cast<const btStaticPlaneShape&>(shape);
        numbers.push_back(to_eigen(plane.getPlaneNormal()));
        numbers.emplace_back(plane.getPlaneConstant(), 0, 0);
    } else if (is_open_surface(shape)) {
        btVector3 low, high;
        shape.getAabb(btTransform::getIdentity(), low, high);
        numbers = {to_eigen(low), to_eigen(high)};
    } else if (const RoundSizes round(shape); round.axis >= 0) {
        numbers.emplace_back(round.radius, round.half_height, 0);
    }
    return numbers;
}

bool sound_leaf(const btCollisionShape& shape, const std::vector<Vec3>& numbers) {
    const bool finite =
        std::all_of(numbers.begin(), numbers.end(), [](const Vec3& v) { return v.allFinite(); });
    switch (shape.getShapeType()) {
        case BOX_SHAPE_PROXYTYPE:
            return finite && numbers[0].minCoeff() > 0;
        case SPHERE_SHAPE_PROXYTYPE:
        case CAPSULE_SHAPE_PROXYTYPE:
            return finite && numbers[0].x() > 0;
        case STATIC_PLANE_PROXYTYPE:
            return finite && numbers[0].norm() > 0;
        default:
            return finite;
    }
}

Shape build_leaf(const btCollisionShape& shape, const std::vector<Vec3>& numbers) {
    switch (shape.getShapeType()) {
        case BOX_SHAPE_PROXYTYPE:
            return make_box(numbers[0]);
        case SPHERE_SHAPE_PROXYTYPE:
            return Sphere{numbers[0].x()};
        case STATIC_PLANE_PROXYTYPE:
            return HalfSpace{numbers[0].normalized(), numbers[1].x()};
        case TRIANGLE_MESH_SHAPE_PROXYTYPE:
        case SCALED_TRIANGLE_MESH_SHAPE_PROXYTYPE:
        case TERRAIN_SHAPE_PROXYTYPE:
            return OpenSurface{numbers[0], numbers[1]};
        case CYLINDER_SHAPE_PROXYTYPE:
            return make_frustum(numbers[0].x(), numbers[0].x(), numbers[0].y());
        case CONE_SHAPE_PROXYTYPE:
            return make_frustum(numbers[0].x(), 0, numbers[0].y());
        case CAPSULE_SHAPE_PROXYTYPE:
            if (numbers[0].y() == 0) {
                return Sphere{numbers[0].x()};
            }
            return make_capsule(numbers[0].x(), numbers[0].y());
        default:
            return convex_hull(numbers).solid;
    }
}

Pose exact_in_leaf(const btCollisionShape& shape) {
    return RoundSizes(shape).turn();
}

double volume(const Shape& shape) {
    return std::visit(Volume{}, shape);
}

}  // namespace scree
