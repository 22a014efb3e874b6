#include <scree/detect/body_shape.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <scree/detect/collision_shapes.hpp>
#include <scree/detect/convert.hpp>
#include <scree/mesh/convex_hull.hpp>
#include <scree/mesh/mass_properties.hpp>

namespace scree {

namespace {

constexpr std::size_t least_kept = 16;

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

[[noreturn]] void refuse(const btCollisionShape& shape, const std::string& reason) {
    throw std::invalid_argument("shape " + std::string(shape.getName()) + ": " + reason);
}

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

// Points and sizes as Bullet has them, scaling included. Empty: a shape that is not done.
std::vector<Vec3> measures(const btCollisionShape& shape) {
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
    } else if (const RoundSizes round(shape); round.axis >= 0) {
        numbers.emplace_back(round.radius, round.half_height, 0);
    }
    return numbers;
}

bool sound(const btCollisionShape& shape, const std::vector<Vec3>& numbers) {
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

Shape build(const btCollisionShape& shape, const std::vector<Vec3>& numbers) {
    switch (shape.getShapeType()) {
        case BOX_SHAPE_PROXYTYPE:
            return make_box(numbers[0]);
        case SPHERE_SHAPE_PROXYTYPE:
            return Sphere{numbers[0].x()};
        case STATIC_PLANE_PROXYTYPE:
            return HalfSpace{numbers[0].normalized(), numbers[1].x()};
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
    part.local = local * RoundSizes(shape).turn();
    part.volume = std::visit(Volume{}, *part.shape);
    body.volume += part.volume;
    body.radius = std::max(body.radius, local.position.norm() + bounding_radius(*part.shape));
    body.parts.push_back(std::move(part));
}

std::shared_ptr<const Shape> ShapeLibrary::simple_shape(const btCollisionShape& shape) {
    const std::vector<Vec3> numbers = measures(shape);
    if (numbers.empty()) {
        refuse(shape,
               "not done; a hull, box, sphere, capsule, cylinder, cone, plane or a compound of these is");
    }
    if (!sound(shape, numbers)) {
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
        made = std::make_shared<const Shape>(build(shape, numbers));
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
