#include "shown_scene_of.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/mesh/surface.hpp>
#include <scree/mesh_io/load_mesh.hpp>

namespace scree {

namespace {

constexpr double margin = 1.2;  // of ground beyond the bodies
constexpr double least = 4;     // sizes of ground about what moves

Vec3 centre_of(const SimulationBody& body) {
    return body.start.pose * body.solid.body_in_file.position;
}

/// How far [m] the body reaches from there; infinite for a half-space.
double reach_of(const SimulationBody& body) {
    double reach = 0;
    for_each_part(body.solid, [&](const Shape& shape, const Vec3& position) {
        reach = std::max(reach, position.norm() + bounding_radius(shape));
    });
    return reach;
}

bool bounded(const SimulationBody& body) {
    return std::isfinite(reach_of(body));
}

/// The middle of the smallest box that has all bounded bodies at their starts.
Vec3 middle_of(const Simulation& simulation) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3 low = Vec3::Constant(infinity);
    Vec3 high = Vec3::Constant(-infinity);
    for (const SimulationBody& body : simulation.bodies()) {
        if (bounded(body)) {
            low = low.cwiseMin(centre_of(body));
            high = high.cwiseMax(centre_of(body));
        }
    }
    return low.x() <= high.x() ? Vec3(0.5 * (low + high)) : Vec3::Zero();
}

/// As much of a half-space as all bodies lie over, whichever body it belongs to.
ShownGround ground_of(const Simulation& simulation, const std::string& shape) {
    const Vec3 middle = middle_of(simulation);
    ShownGround ground;
    double farthest = 0;
    bool first = true;
    for (const SimulationBody& own : simulation.bodies()) {
        if (own.shape != shape) {
            continue;
        }
        ground.about = first ? own.start.pose.inverse() * middle : ground.about;
        first = false;
        const Vec3 about = own.start.pose * ground.about;
        for (const SimulationBody& body : simulation.bodies()) {
            if (bounded(body)) {
                farthest = std::max({farthest, (centre_of(body) - about).norm() + reach_of(body),
                                     body.dynamic() ? least / margin * reach_of(body) : 0});
            }
        }
    }
    ground.half_width = farthest > 0 ? margin * farthest : 1;
    return ground;
}

/// The triangles of the file, as the plates that stand for them look.
ShownMesh surface_of(const std::string& name, const MeshShape& shape, const Simulation& simulation) {
    const TriangleMesh file = load_mesh(simulation.scene().file.parent_path() / shape.file, shape.scale);
    const Surface oriented = oriented_surface(file);
    return shown_surface(name, oriented.closed ? oriented.mesh : file);
}

/// The shape, or all of its parts.
ShownMesh solid_mesh(const std::string& name, const Solid& solid, const ShownGround& ground) {
    ShownMesh mesh;
    mesh.name = name;
    for_each_part(solid, [&](const Shape& shape, const Vec3& position) {
        const Pose pose = solid.body_in_file * Pose{position, Quat::Identity()};
        const ShownMesh part = shown_mesh(name, shape, pose, ground);
        mesh.corners.insert(mesh.corners.end(), part.corners.begin(), part.corners.end());
    });
    return mesh;
}

ShownMesh mesh_of(const std::string& name, const Solid& solid, const Simulation& simulation) {
    const auto* file = std::get_if<MeshShape>(&simulation.scene().shapes.at(name));
    if (file != nullptr && file->parts == Parts::surface) {
        return surface_of(name, *file, simulation);
    }
    const bool is_ground = std::holds_alternative<HalfSpace>(*solid.shape);
    return solid_mesh(name, solid, is_ground ? ground_of(simulation, name) : ShownGround());
}

}  // namespace

ShownScene shown_scene_of(const Simulation& simulation) {
    ShownScene scene;
    std::map<std::string, std::size_t> numbers;
    for (const auto& [name, solid] : simulation.solids()) {
        numbers[name] = scene.meshes.size();
        scene.meshes.push_back(mesh_of(name, solid, simulation));
    }
    for (const SimulationBody& body : simulation.bodies()) {
        scene.bodies.push_back({body.name, numbers.at(body.shape), body.size, moves(body), body.start.pose});
    }
    return scene;
}

bool moves(const SimulationBody& body) {
    return !std::holds_alternative<FixedMotion>(body.motion);
}

std::vector<Pose> moving_poses(const Simulation& simulation) {
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < simulation.bodies().size(); ++i) {
        if (moves(simulation.bodies()[i])) {
            poses.push_back(simulation.file_motion(i).pose);
        }
    }
    return poses;
}

}  // namespace scree
