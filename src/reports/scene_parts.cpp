#include "scene_parts.hpp"

#include <cmath>
#include <random>

#include <scree/mesh/mass_properties.hpp>
#include <scree/output/output_folder.hpp>
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

std::filesystem::path meshes_folder(const std::filesystem::path& report) {
    return report / "meshes";
}

std::filesystem::path write_round_stone(const std::filesystem::path& report, int points) {
    std::mt19937_64 random(static_cast<std::uint64_t>(points));
    const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    std::string text;
    for (int i = 0; i < points; ++i) {
        const double z = 2 * uniform() - 1;
        const double turn = 2 * std::acos(-1) * uniform();
        const double r = std::sqrt(1 - z * z);
        text += "v " + std::to_string(0.5 * r * std::cos(turn)) + " " +
                std::to_string(0.45 * r * std::sin(turn)) + " " + std::to_string(0.4 * z) + "\n";
    }
    for (int i = 1; i + 2 <= points; ++i) {
        text += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
    }
    std::filesystem::create_directories(meshes_folder(report));
    const std::filesystem::path file = meshes_folder(report) / ("stone_" + std::to_string(points) + ".obj");
    write_whole(file, text);
    return file;
}

}  // namespace scree
