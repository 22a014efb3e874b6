// Blocks on slopes of their own: two that hold still and two that slide, downhill along odd directions.

#include <cmath>
#include <numbers>

#include "problem.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

constexpr double friction = 0.5;
constexpr double degree = std::numbers::pi / 180;

struct Slope {
    const char* mesh;
    double scale;    ///< [m] per unit of the mesh
    double height;   ///< of its middle above its base, in units of the mesh
    double angle;    ///< [rad]
    double azimuth;  ///< [rad], of the downhill direction
    double turn;     ///< [rad], of the block about the slope's normal
};

constexpr Slope slopes[] = {
    {"cube", 0.1, 0.5, 20 * degree, 37 * degree, 0.4},
    {"hexagonal_prism", 0.2, 0.3, 26 * degree, 221 * degree, 1.1},
    {"cube", 0.1, 0.5, 35 * degree, 31 * degree, 0},
    {"hexagonal_prism", 0.2, 0.3, 29 * degree, 118 * degree, 0.3},
};

Vec3 level_axis(const Slope& slope) {
    return {-std::sin(slope.azimuth), std::cos(slope.azimuth), 0};
}

/// From the frame of a slope, z its normal, to the world's.
Pose frame(std::size_t number) {
    const Slope& slope = slopes[number];
    return {Vec3(10.0 * static_cast<double>(number), 0, 0),
            Quat(Eigen::AngleAxisd(slope.angle, level_axis(slope)))};
}

void add_slope(SceneDescription& scene, std::size_t number) {
    const Slope& slope = slopes[number];
    const std::string shape = slope.mesh;
    scene.shapes[shape] = shipped_mesh(shape, slope.scale);
    add_fixed(scene, "slab", frame(number));
    const Pose block = frame(number) * Pose{Vec3(0, 0, slope.height * slope.scale),
                                            Quat(Eigen::AngleAxisd(slope.turn, Vec3::UnitZ()))};
    add_body(scene, shape, block.position).orientation = block.orientation;
}

Vec3 downhill(const Slope& slope) {
    return {std::cos(slope.azimuth), std::sin(slope.azimuth), 0};
}

/// Displacements in the frame of the slope, downhill, across and up, over the block's size, and its turn.
Values observe(const Simulation& simulation) {
    Values values;
    for (std::size_t i = 0; i < std::size(slopes); ++i) {
        const FrameMotion& start = simulation.bodies()[2 * i + 1].start;
        const FrameMotion now = simulation.file_motion(2 * i + 1);
        const Vec3 moved = frame(i).orientation.conjugate() * (now.pose.position - start.pose.position);
        const Vec3 along = downhill(slopes[i]);
        values.push_back(along.dot(moved) / slopes[i].scale);
        values.push_back(along.cross(Vec3::UnitZ()).dot(moved) / slopes[i].scale);
        values.push_back(moved.z() / slopes[i].scale);
        values.push_back(now.pose.orientation.angularDistance(start.pose.orientation));
    }
    return values;
}

Values rigid(double time) {
    Values values;
    for (const Slope& slope : slopes) {
        const double acceleration =
            earth_gravity * (std::sin(slope.angle) - friction * std::cos(slope.angle));
        values.push_back(std::max(0.0, acceleration) * time * time / 2 / slope.scale);
        values.insert(values.end(), {0, 0, 0});
    }
    return values;
}

std::vector<std::string> quantities() {
    std::vector<std::string> names;
    for (const Slope& slope : slopes) {
        const std::string at = " at " + std::to_string(std::lround(slope.angle / degree)) + " degrees";
        for (const char* what : {"slide", "drift", "lift", "turn"}) {
            names.push_back(what + at);
        }
    }
    return names;
}

}  // namespace

Problem incline_problem() {
    Problem problem = bare_problem("incline", 1, 4);
    problem.purpose =
        "Four mesh blocks of 0.1 and 0.2 m on slopes of 20, 26, 29 and 35 degrees, downhill along odd "
        "directions, for a second: by Coulomb's law with friction 0.5 the first two hold still and the "
        "others slide with g (sin θ − μ cos θ). The error is the largest difference in place, in units of "
        "the block's size, or in turn [rad].";
    problem.scene.materials["rock"].friction = friction;
    problem.scene.shapes["slab"] = shipped_mesh("slab", 4);
    for (std::size_t i = 0; i < std::size(slopes); ++i) {
        add_slope(problem.scene, i);
    }
    problem.quantities = quantities();
    problem.observe = observe;
    problem.rigid = rigid;
    problem.references = {adaptive_bdf(2, 1e-8), explicit_method(SteppingMethod::verlet, 1e-6)};
    return problem;
}

}  // namespace scree
