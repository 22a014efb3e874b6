#include "scene_parts.hpp"

#include <cmath>

#include <scree/mesh/mass_properties.hpp>
#include <scree/scenes/find_scene.hpp>

namespace scree {

SceneDescription bare_scene(const std::string& name, double end_time, int looks) {
    SceneDescription scene;
    scene.name = name;
    scene.gravity = -earth_gravity * Vec3::UnitZ();
    MaterialDescription& rock = scene.materials["rock"];
    rock.density = 2600;
    rock.youngs_modulus = 1e10;
    rock.friction = 0.5;
    scene.end_time = end_time;
    scene.output.every = end_time / looks;
    return scene;
}

MeshShape shipped_mesh(const std::string& name, double scale) {
    MeshShape mesh;
    mesh.file = find_scene("incline").parent_path() / "../../meshes" / (name + ".obj");
    mesh.scale = Vec3::Constant(scale);
    return mesh;
}

BodyDescription& add_body(SceneDescription& scene, const std::string& shape, const Vec3& position) {
    BodyDescription& body = scene.bodies.emplace_back();
    body.shape = shape;
    body.material = "rock";
    body.position = position;
    return body;
}

BodyDescription& add_fixed(SceneDescription& scene, const std::string& shape, const Pose& pose) {
    BodyDescription& body = add_body(scene, shape, pose.position);
    body.orientation = pose.orientation;
    body.motion = FixedMotion{};
    return body;
}

BodyDescription& add_floor(SceneDescription& scene) {
    scene.shapes["floor"] = HalfSpace{};
    return add_fixed(scene, "floor", {});
}

double sunk_depth(double load, double volume, double area, double youngs_modulus) {
    return load * 2 * sphere_radius(volume) / (youngs_modulus * area);
}

Vec3 odd_direction() {
    constexpr double azimuth = 0.65;  // [rad]
    return {std::cos(azimuth), std::sin(azimuth), 0};
}

}  // namespace scree
