// The greatest step with which a method keeps a cube at rest.

#include <algorithm>
#include <cmath>
#include <memory>

#include "scene_parts.hpp"
#include "stability.hpp"

namespace scree {

namespace {

const Row columns = {"method", "Y", "step", "limit", "settings", "runs"};
const Row keys = {"method", "Y", "settings"};

constexpr double edge = 0.1;           // [m]
constexpr double least_step = 1e-7;    // [s]
constexpr double greatest_step = 0.1;  // [s]
constexpr double steps_made = 400;
constexpr double near = 1.1;  // the bisection ends when the bounds are that close

/// Pushed a little, so that what is unstable grows.
Problem disturbed_cube(const MethodChoice& method, double youngs_modulus, double step) {
    Problem problem = bare_problem("rest", steps_made * step, 10);
    SceneDescription& scene = problem.scene;
    scene.materials["rock"].youngs_modulus = youngs_modulus;
    scene.shapes["cube"] = shipped_mesh("cube", edge);
    add_floor(scene);
    const double weight = 2600 * edge * edge * edge * earth_gravity;
    const double depth =
        method.by_bullet() ? 0 : sunk_depth(weight, edge * edge * edge, edge * edge, youngs_modulus);
    BodyDescription& cube = add_body(scene, "cube", Vec3(0, 0, edge / 2 - depth));
    cube.velocity = Vec3(1e-4, 2e-4, -1e-4);
    problem.quantities = {"place", "speed"};
    problem.observe = [](const Simulation& simulation) {
        const FrameMotion now = simulation.file_motion(1);
        return Values{(now.pose.position - simulation.bodies()[1].start.pose.position).norm() / edge,
                      now.velocity.norm()};
    };
    return problem;
}

/// Whether the cube is where it was, and no faster than it was pushed.
bool stable(const MethodChoice& method, double youngs_modulus, double step) {
    MethodChoice with = method;
    with.stepping.step = step;
    const Problem problem = disturbed_cube(method, youngs_modulus, step);
    const Observation seen = observe_run(problem, with, {2});
    return seen.finished && std::all_of(seen.samples.begin(), seen.samples.end(), [](const Values& sample) {
               return sample[0] < 1e-2 && sample[1] < 1e-3;
           });
}

Row measured(const MethodChoice& method, double youngs_modulus) {
    double low = least_step;
    double high = low;
    int runs = 0;
    bool all = true;
    // Larger and larger until the first that is not: above it some may be stable again.
    while (all && high < greatest_step) {
        low = high;
        high = std::min(greatest_step, 2 * high);
        all = stable(method, youngs_modulus, high);
        ++runs;
    }
    while (!all && high / low > near) {
        const double middle = std::sqrt(low * high);
        (stable(method, youngs_modulus, middle) ? low : high) = middle;
        ++runs;
    }
    return {method.name(),     cell(youngs_modulus), cell(all ? high : low), all ? "none found" : "reached",
            method.settings(), std::to_string(runs)};
}

std::vector<MethodChoice> methods() {
    return {fixed_bdf(1, 1),
            fixed_bdf(2, 1),
            fixed_bdf(3, 1),
            fixed_bdf(4, 1),
            fixed_bdf(5, 1),
            explicit_method(SteppingMethod::symplectic_euler, 1),
            explicit_method(SteppingMethod::verlet, 1),
            bullet_method(1, 10)};
}

}  // namespace

Table stable_steps_table(const std::filesystem::path& folder) {
    return {folder / "stable_steps.csv", columns, keys};
}

std::vector<Case> stable_step_cases(const ReportRequest& request) {
    const auto table = std::make_shared<Table>(stable_steps_table(request.out));
    const Budget budget{20};
    std::vector<Case> cases;
    if (!wanted(request, "stable_steps")) {
        return cases;
    }
    for (const MethodChoice& method : methods()) {
        for (int power = 5; power <= 13; power += request.quick ? 2 : 1) {
            const double modulus = std::pow(10, power);
            if (table->has({method.name(), cell(modulus), method.settings()})) {
                continue;
            }
            cases.push_back({"greatest stable step of " + method.name() + " at Y = " + cell(modulus), [=] {
                                 const Isolated answer =
                                     isolated_row([&] { return measured(method, modulus); }, budget);
                                 table->add(answer.done ? answer.row
                                                        : Row{method.name(), cell(modulus), "",
                                                              answer.message, method.settings(), ""});
                             }});
        }
    }
    return cases;
}

}  // namespace scree
