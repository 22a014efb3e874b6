#include <scree/world/automatic_material.hpp>

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <scree/mesh/mass_properties.hpp>
#include <scree/overlap/overlap.hpp>

namespace scree {

namespace {

constexpr double sinking = 1e-4;        // of ℓ
constexpr double least_gravity = 9.81;  // [m/s²]
constexpr double infinity = std::numeric_limits<double>::infinity();

double volume_below(const Shape& shape, const HalfSpace& ground) {
    OverlapWorkspace workspace;
    ContactGeometry geometry;
    const bool any = overlap(shape, Pose(), ground, Pose(), Detail::force, false, workspace, geometry);
    return any ? geometry.volume : 0;
}

// Whether the solid stays on a face that lies on the ground: its centroid is above the face.
bool rests_on(const ConvexPolyhedron& solid, int face, const Vec3& centroid) {
    const auto begin = static_cast<std::size_t>(solid.face_begin[static_cast<std::size_t>(face)]);
    const auto end = static_cast<std::size_t>(solid.face_begin[static_cast<std::size_t>(face) + 1]);
    const Vec3& normal = solid.planes[static_cast<std::size_t>(face)].normal;
    for (std::size_t e = begin; e < end; ++e) {
        const Vec3& here = solid.vertices[static_cast<std::size_t>(solid.half_edges[e].vertex)];
        const std::size_t after = e + 1 < end ? e + 1 : begin;
        const Vec3& next = solid.vertices[static_cast<std::size_t>(solid.half_edges[after].vertex)];
        if ((next - here).cross(centroid - here).dot(normal) < 0) {
            return false;
        }
    }
    return true;
}

double resting_volume_of(const ConvexPolyhedron& solid, const Shape& shape, double depth) {
    const Vec3 centroid = mass_properties(solid).centroid;
    double least = infinity;
    for (int f = 0; f < solid.face_count(); ++f) {
        if (rests_on(solid, f, centroid)) {
            const Plane& face = solid.planes[static_cast<std::size_t>(f)];
            least = std::min(least, volume_below(shape, {-face.normal, depth - face.offset}));
        }
    }
    return least;
}

bool has_stiffness(const btCollisionObject& object) {
    return (object.getCollisionFlags() & btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING) != 0;
}

// γn with which a face of area Lc² has a damper [N s/m] beside a spring [N/m].
double damping_of(double damper, double spring, double mass) {
    return std::max(0.0, damper) / std::sqrt(spring * mass);
}

// Where a round shape can lie down on, in its own frame.
std::vector<Vec3> directions_of_rest(const Shape& shape) {
    std::vector<Vec3> directions;
    if (std::holds_alternative<Sphere>(shape) || std::holds_alternative<Capsule>(shape)) {
        directions.push_back(Vec3::UnitX());
    } else if (const auto* frustum = std::get_if<Frustum>(&shape)) {
        const double slope = 0.5 * (frustum->bottom - frustum->top) / frustum->half_height;
        directions.push_back(Vec3(1, 0, slope).normalized());
        if (frustum->bottom > 0) {
            directions.emplace_back(-Vec3::UnitZ());
        }
        if (frustum->top > 0) {
            directions.push_back(Vec3::UnitZ());
        }
    }
    return directions;
}

}  // namespace

// Written in θ = arccos ζ as exp(−2ζ θ/sin θ), whose limit at ζ = 1 is e⁻².
double restitution(double damping_ratio) {
    const double sine = std::sqrt((1 - damping_ratio) * (1 + damping_ratio));
    const double ratio = sine > 1e-8 ? std::acos(damping_ratio) / sine : 1;
    return std::exp(-2 * damping_ratio * ratio);
}

double damping_ratio(double restitution_wanted) {
    if (restitution_wanted <= restitution(1)) {
        return 1;
    }
    double low = 0;
    double high = 1;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (restitution(middle) > restitution_wanted ? low : high) = middle;
    }
    return restitution_wanted < 1 ? 0.5 * (low + high) : 0;
}

double normal_damping(double damping_ratio) {
    return 2 * damping_ratio;
}

double resting_volume(const Shape& shape, double depth) {
    if (const auto* solid = std::get_if<ConvexPolyhedron>(&shape)) {
        return resting_volume_of(*solid, shape, depth);
    }
    double least = infinity;
    for (const Vec3& down : directions_of_rest(shape)) {
        least = std::min(least, volume_below(shape, {-down, depth - reach_along(shape, down)}));
    }
    return least;
}

SurfaceProperties surface_properties(const btCollisionObject& object) {
    SurfaceProperties surface;
    surface.friction = object.getFriction();
    surface.restitution = object.getRestitution();
    surface.rolling_friction = object.getRollingFriction();
    if (has_stiffness(object)) {
        surface.stiffness = object.getContactStiffness();
        surface.damping = object.getContactDamping();
    }
    return surface;
}

Material automatic_material(const UnnamedBody& body, const BodyShape& shape, double gravity) {
    const SurfaceProperties& surface = body.surface;
    Material material;
    material.friction = std::max(surface.friction, 0.0);
    material.normal_damping = normal_damping(damping_ratio(surface.restitution));
    material.youngs_modulus = infinity;
    if (std::isinf(body.mass)) {
        return material;
    }
    material.density = body.mass / shape.volume;
    const double length = characteristic_length({body.mass, body.radius}, {});
    material.rolling_friction = std::max(surface.rolling_friction, 0.0) / (0.5 * length);
    if (surface.stiffness < infinity) {
        material.youngs_modulus = surface.stiffness / length;
        material.normal_damping = damping_of(surface.damping, surface.stiffness, body.mass);
        return material;
    }
    double volume = infinity;
    for (const BodyPart& part : shape.parts) {
        volume = std::min(volume, resting_volume(*part.shape, sinking * body.radius));
    }
    material.youngs_modulus = body.mass * std::max(gravity, least_gravity) * length / volume;
    return material;
}

PairMaterial combined_by_bullet(PairMaterial pair, const btCollisionObject& object_a, const BodySize& a,
                                const btCollisionObject& object_b, const BodySize& b) {
    pair.even_damping = true;  // a ball, too, is to bounce as its restitution says
    pair.friction = std::max(0.0, gCalculateCombinedFrictionCallback(&object_a, &object_b));
    const double rolling = gCalculateCombinedRollingFrictionCallback(&object_a, &object_b);
    pair.rolling_friction = std::max(0.0, rolling) / (0.5 * characteristic_length(a, b));
    if (has_stiffness(object_a) || has_stiffness(object_b)) {
        const double stiffness = gCalculateCombinedContactStiffnessCallback(&object_a, &object_b);
        const double damping = gCalculateCombinedContactDampingCallback(&object_a, &object_b);
        pair.youngs_modulus = stiffness / characteristic_length(a, b);
        pair.normal_damping = damping_of(damping, stiffness, reduced_mass(a, b));
    } else {
        const double bounce = gCalculateCombinedRestitutionCallback(&object_a, &object_b);
        pair.normal_damping = normal_damping(damping_ratio(bounce));
    }
    return pair;
}

}  // namespace scree
