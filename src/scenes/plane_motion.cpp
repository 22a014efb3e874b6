#include "plane_motion.hpp"

#include <scree/scenes/scene_error.hpp>

#include "json_text.hpp"

namespace scree {

namespace {

constexpr double flat = 1e-6;  // of a mesh's size: files are of single precision

[[noreturn]] void refuse(const std::string& place, const std::string& found, const char* expected) {
    throw SceneError(place, found,
                     std::string(expected) + ", for law.friction is for motion in the x–z plane");
}

void require_zero(double value, const std::string& place) {
    if (value != 0) {
        refuse(place, shown(Json(value)), "0");
    }
}

void check_spin(const Vec3& spin, const std::string& place) {
    require_zero(spin.x(), place + ".0");
    require_zero(spin.z(), place + ".2");
}

void check_motion(const PrescribedMotion& motion, const std::string& place) {
    require_zero(motion.velocity.y(), place + ".velocity.1");
    check_spin(motion.angular_velocity, place + ".angular_velocity");
    require_zero(motion.surface_velocity.y(), place + ".surface_velocity.1");
}

void check_shape(const SceneDescription& scene, const BodyDescription& body, const std::string& place) {
    const ShapeDescription& shape = scene.shapes.at(body.shape);
    if (const auto* half_space = std::get_if<HalfSpace>(&shape)) {
        require_zero(half_space->normal.y(), "shapes." + body.shape + ".half_space.normal.1");
    } else if (!std::holds_alternative<MeshShape>(shape)) {
        require_zero(body.position.y(), place + ".position.1");
    }
}

void check_body(const SceneDescription& scene, const BodyDescription& body, const std::string& place) {
    check_shape(scene, body, place);
    if (body.orientation.x() != 0 || body.orientation.z() != 0) {
        refuse(place + ".orientation", "a turn about another axis than y", "[w, 0, y, 0]");
    }
    require_zero(body.velocity.y(), place + ".velocity.1");
    check_spin(body.angular_velocity, place + ".angular_velocity");
    if (const auto* motion = std::get_if<PrescribedMotion>(&body.motion)) {
        check_motion(*motion, place + ".motion");
    }
}

// Whether the mirror image in the x–z plane of a convex solid at a pose lies within the solid itself.
bool halved(const ConvexPolyhedron& solid, const Pose& pose) {
    const Pose back = pose.inverse();
    for (const Vec3& vertex : solid.vertices) {
        Vec3 image = pose * vertex;
        image.y() = -image.y();
        image = back * image;
        for (const Plane& plane : solid.planes) {
            if (plane.normal.dot(image) > plane.offset + flat * solid.radius) {
                return false;
            }
        }
    }
    return true;
}

bool in_plane(const SceneDescription& scene) {
    return scene.law.friction == FrictionLaw::cundall_strack_2d;
}

}  // namespace

void check_plane_motion(const SceneDescription& scene) {
    if (!in_plane(scene)) {
        return;
    }
    require_zero(scene.gravity.y(), "gravity.1");
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        check_body(scene, scene.bodies[i], "bodies." + std::to_string(i));
    }
    if (!scene.fill.empty()) {
        refuse("fill", "bodies at random", "none");
    }
}

void check_plane_meshes(const SceneDescription& scene, const std::map<std::string, Solid>& solids) {
    for (std::size_t i = 0; in_plane(scene) && i < scene.bodies.size(); ++i) {
        const BodyDescription& body = scene.bodies[i];
        const Solid& solid = solids.at(body.shape);
        const auto* polyhedron = std::get_if<ConvexPolyhedron>(solid.shape.get());
        const Pose pose = Pose{body.position, body.orientation} * solid.body_in_file;
        if (polyhedron != nullptr && !halved(*polyhedron, pose)) {
            refuse("bodies." + std::to_string(i),
                   in_quotes(body.shape) + ", which the plane y = 0 does not halve",
                   "a mesh that is its own mirror image there");
        }
    }
}

}  // namespace scree
