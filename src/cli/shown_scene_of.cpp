#include "shown_scene_of.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

constexpr double margin = 1.2;  // of ground beyond the bodies

bool bounded(const SimulationBody& body) {
    return std::isfinite(bounding_radius(*body.solid.shape));
}

/// The middle of the smallest box that has all bounded bodies at their starts.
Vec3 middle_of(const Simulation& simulation) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3 low = Vec3::Constant(infinity);
    Vec3 high = Vec3::Constant(-infinity);
    for (const SimulationBody& body : simulation.bodies()) {
        if (bounded(body)) {
            low = low.cwiseMin(body.start.pose.position);
            high = high.cwiseMax(body.start.pose.position);
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
                const double radius = bounding_radius(*body.solid.shape);
                farthest = std::max(farthest, (body.start.pose.position - about).norm() + radius);
            }
        }
    }
    ground.half_width = farthest > 0 ? margin * farthest : 1;
    return ground;
}

}  // namespace

ShownScene shown_scene_of(const Simulation& simulation) {
    ShownScene scene;
    std::map<std::string, std::size_t> numbers;
    for (const auto& [name, solid] : simulation.solids()) {
        const bool is_ground = std::holds_alternative<HalfSpace>(*solid.shape);
        const ShownGround ground = is_ground ? ground_of(simulation, name) : ShownGround();
        numbers[name] = scene.meshes.size();
        scene.meshes.push_back(shown_mesh(name, *solid.shape, solid.body_in_file, ground));
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
