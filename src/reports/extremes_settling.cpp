// A cube that settles on the floor: stiff and soft, small and large, light and heavy gravity, far away, by
// any step, and in other units.

#include <cmath>

#include "scene_parts.hpp"
#include "stability.hpp"

namespace scree {

namespace {

constexpr double first_height = 0.05;  // over the edge
constexpr double first_tilt = 0.02;    // [rad]
constexpr double falls = 25;           // the time, in times to fall by an edge, that it has to settle

/// Lowest point over the floor, in sizes, and speed over that of a fall by its size.
Values resting(const Simulation& simulation, const Settling& settling) {
    const FrameMotion now = simulation.body_motion(1);
    const double lowest = bounds(*simulation.bodies()[1].solid.shape, now.pose).low.z() - settling.place.z();
    const double speed = now.velocity.norm() + settling.edge * now.angular_velocity.norm();
    return {lowest / settling.edge, speed / std::sqrt(settling.gravity * settling.edge)};
}

/// Where the law bears the cube, lying flat, Eq. (5.7); of other shapes it is not counted.
double depth_of(const Settling& settling) {
    if (settling.shape) {
        return 0;
    }
    const double volume = std::pow(settling.edge, 3);
    return sunk_depth(settling.density * volume * settling.gravity, volume, settling.edge * settling.edge,
                      settling.youngs_modulus);
}

double lowest_of(const ShapeDescription& shape, const Quat& turn) {
    const Solid solid = make_solid(shape, {});
    return bounds(*solid.shape, Pose{Vec3::Zero(), turn} * solid.body_in_file).low.z();
}

void add(std::vector<Extreme>& all, const std::string& axis, double value, const Settling& settling) {
    all.push_back({axis, cell(value), settling_problem(settling)});
}

/// The same in millimetres: kg/(mm s²) in place of Pa.
Settling in_millimetres(const Settling& metres) {
    Settling other = metres;
    other.edge *= 1e3;
    other.gravity *= 1e3;
    other.youngs_modulus *= 1e-3;
    other.density *= 1e-9;
    return other;
}

void add_steps(std::vector<Extreme>& all, bool quick) {
    for (const double step : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
        if (quick && step < 1e-5) {
            continue;
        }
        Extreme extreme{"step", cell(step), settling_problem({})};
        extreme.problem.scene.output.every = std::max(step, extreme.problem.scene.output.every);
        extreme.methods = {fixed_bdf(1, step),
                           fixed_bdf(2, step),
                           fixed_bdf(3, step),
                           fixed_bdf(5, step),
                           explicit_method(SteppingMethod::symplectic_euler, step),
                           explicit_method(SteppingMethod::verlet, step),
                           bullet_method(step, 10),
                           bullet_at_best(step, 50)};
        all.push_back(extreme);
    }
}

}  // namespace

Problem settling_problem(const Settling& settling) {
    Problem problem = bare_problem("settling", falls * std::sqrt(settling.edge / settling.gravity), 20);
    SceneDescription& scene = problem.scene;
    scene.gravity = -settling.gravity * Vec3::UnitZ();
    scene.materials["rock"].youngs_modulus = settling.youngs_modulus;
    scene.materials["rock"].density = settling.density;
    scene.shapes["body"] = settling.shape.value_or(shipped_mesh("cube", settling.edge));
    add_floor(scene).position = settling.place;
    const Quat tilt(Eigen::AngleAxisd(first_tilt, Vec3(2, 1, 0).normalized()));
    BodyDescription& body = add_body(scene, "body", settling.place);
    body.position.z() += first_height * settling.edge - lowest_of(scene.shapes["body"], tilt);
    body.orientation = tilt;
    problem.quantities = {"lowest point", "speed"};
    problem.observe = [settling](const Simulation& simulation) { return resting(simulation, settling); };
    problem.model = [end = -depth_of(settling) / settling.edge](double) { return Values{end, 0}; };
    problem.last_only = true;
    return problem;
}

void add_settling(std::vector<Extreme>& all, bool quick) {
    for (int power = 3; power <= 13; power += quick ? 2 : 1) {
        Settling settling;
        settling.edge = 0.005;  // on the softest ground a larger cube would float on an edge, or drown
        settling.youngs_modulus = std::pow(10, power);
        add(all, "Y [Pa]", settling.youngs_modulus, settling);
    }
    add_steps(all, quick);
    for (const double size : {1e-6, 1e-3, 1.0, 1e3}) {
        Settling settling;
        settling.edge = size;
        settling.youngs_modulus = 1e10;
        add(all, "size [m]", size, settling);
    }
    for (const double times : {1e-6, 1e-3, 1.0, 1e2, 1e4}) {
        Settling settling;
        settling.gravity *= times;
        settling.youngs_modulus = 1e10;
        add(all, "gravity [g]", times, settling);
    }
    for (const double away : {1e3, 1e6}) {
        Settling settling;
        Extreme extreme{"origin [m]", cell(away), settling_problem(settling)};
        extreme.twin = extreme.problem;
        settling.place = Vec3(away, -away, 0);
        extreme.problem = settling_problem(settling);
        all.push_back(extreme);
    }
    Extreme units{"units", "mm", settling_problem(in_millimetres({}))};
    units.twin = settling_problem({});
    units.limit = 1e-6;
    all.push_back(units);
}

}  // namespace scree
