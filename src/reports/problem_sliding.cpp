// A cube that is pushed slides until friction has stopped it, and a ball until it rolls.

#include <cmath>
#include <numbers>

#include "problem.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

constexpr double cube_friction = 0.5;
constexpr double ball_friction = 0.3;
constexpr double speed = 1;      // [m/s], at first
constexpr double edge = 0.1;     // [m]
constexpr double radius = 0.05;  // [m]

Vec3 moved(const Simulation& simulation) {
    return simulation.file_motion(1).pose.position - simulation.bodies()[1].start.pose.position;
}

Values cube_values(const Simulation& simulation) {
    const Vec3 way = moved(simulation) / edge;
    const Quat& start = simulation.bodies()[1].start.pose.orientation;
    return {way.dot(odd_direction()), way.dot(odd_direction().cross(Vec3::UnitZ())), way.z(),
            simulation.file_motion(1).pose.orientation.angularDistance(start)};
}

Values rigid_cube(double time) {
    const double deceleration = cube_friction * earth_gravity;
    const double moving = std::min(time, speed / deceleration);
    return {(speed - deceleration * moving / 2) * moving / edge, 0, 0, 0};
}

Values ball_values(const Simulation& simulation) {
    const Vec3 way = moved(simulation) / radius;
    const FrameMotion now = simulation.file_motion(1);
    const Vec3 axis = Vec3::UnitZ().cross(odd_direction());
    return {way.dot(odd_direction()), way.dot(axis), now.velocity.dot(odd_direction()) / speed,
            now.angular_velocity.dot(axis) * radius / speed};
}

Values rigid_ball(double time) {
    // Friction slows the ball by μ g and turns it by 5/2 μ g/r until v = ω r, at 5/7 of the first speed.
    const double deceleration = ball_friction * earth_gravity;
    const double slipping = std::min(time, 2 * speed / (7 * deceleration));
    const double last = speed - deceleration * slipping;
    const double way = (speed + last) / 2 * slipping + last * (time - slipping);
    return {way / radius, 0, last / speed, 2.5 * deceleration * slipping / speed};
}

/// On a half-space a ball sinks in until (Y/Lc) π δ² (r − δ/3) bears it, Eq. (5.7).
double ball_depth(const SceneDescription& scene) {
    const Material& rock = scene.materials.at("rock");
    const double weight = rock.density * 4 / 3 * std::numbers::pi * std::pow(radius, 3) * earth_gravity;
    const double volume = weight * 2 * radius / rock.youngs_modulus;
    double depth = 0;
    for (int i = 0; i < 50; ++i) {
        depth = std::sqrt(volume / (std::numbers::pi * (radius - depth / 3)));
    }
    return depth;
}

}  // namespace

Problem sliding_to_rest_problem() {
    Problem problem = bare_problem("sliding_to_rest", 0.3, 3);
    problem.purpose =
        "A cube of 0.1 m slides at 1 m/s in an odd direction until friction 0.5 has stopped it: after v/(μ "
        "g), and v²/(2 μ g) farther. The error is the largest difference in place, in edges, or in turn "
        "[rad].";
    SceneDescription& scene = problem.scene;
    scene.shapes["cube"] = shipped_mesh("cube", edge);
    add_floor(scene);
    const double weight = 2600 * edge * edge * edge * earth_gravity;
    const double depth = sunk_depth(weight, edge * edge * edge, edge * edge, 1e10);
    add_body(scene, "cube", Vec3(0, 0, edge / 2 - depth)).velocity = speed * odd_direction();
    problem.quantities = {"way", "drift", "lift", "turn"};
    problem.observe = cube_values;
    problem.rigid = rigid_cube;
    problem.references = {adaptive_bdf(2, 1e-8), explicit_method(SteppingMethod::verlet, 5e-7)};
    return problem;
}

Problem rolling_problem() {
    Problem problem = bare_problem("rolling_transition", 0.3, 3);
    problem.purpose =
        "A ball of radius 0.05 m slides at 1 m/s without spin until, after 2 v/(7 μ g), it rolls at 5/7 of "
        "that. The error is the largest difference in place, in radii, or in velocity or rim speed, over v.";
    SceneDescription& scene = problem.scene;
    scene.materials["rock"].friction = ball_friction;
    scene.shapes["ball"] = Sphere{radius};
    add_floor(scene);
    add_body(scene, "ball", Vec3(0, 0, radius - ball_depth(scene))).velocity = speed * odd_direction();
    problem.quantities = {"way", "drift", "velocity", "rim speed"};
    problem.observe = ball_values;
    problem.rigid = rigid_ball;
    problem.references = {adaptive_bdf(2, 1e-8), explicit_method(SteppingMethod::verlet, 5e-7)};
    return problem;
}

}  // namespace scree
