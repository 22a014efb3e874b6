// Friction from none to all, and damping from none to a hundred times critical.

#include <cmath>

#include <scree/mesh/mass_properties.hpp>

#include "scene_parts.hpp"
#include "stability.hpp"

namespace scree {

namespace {

constexpr double edge = 0.1;     // [m]
constexpr double slope = 0.349;  // [rad], 20 degrees

Problem friction_problem(double friction) {
    Problem problem = bare_problem("friction", 0.5, 10);
    SceneDescription& scene = problem.scene;
    scene.materials["rock"].friction = friction;
    scene.gravity = earth_gravity * (std::sin(slope) * odd_direction() - std::cos(slope) * Vec3::UnitZ());
    scene.shapes["cube"] = shipped_mesh("cube", edge);
    add_floor(scene);
    add_body(scene, "cube", Vec3(0, 0, edge / 2));
    problem.quantities = {"slide", "drift"};
    problem.observe = [](const Simulation& simulation) {
        const Vec3 moved =
            (simulation.file_motion(1).pose.position - simulation.bodies()[1].start.pose.position) / edge;
        return Values{moved.dot(odd_direction()), moved.dot(odd_direction().cross(Vec3::UnitZ()))};
    };
    const double acceleration = std::max(0.0, earth_gravity * (std::sin(slope) - friction * std::cos(slope)));
    problem.model = [=](double time) { return Values{acceleration * time * time / 2 / edge, 0}; };
    problem.last_only = true;
    return problem;
}

/// Height [m] of a cube that falls flat from 0.02 m, after a time [s]: Eq. (5.7) on a face, by many small
/// steps of the classical Runge–Kutta method.
double fallen(double ratio, double frequency, double time) {
    const auto acceleration = [&](double height, double velocity) {
        const double push = -frequency * frequency * height - 2 * ratio * frequency * velocity;
        return (height < 0 ? std::max(0.0, push) : 0) - earth_gravity;
    };
    const int steps = static_cast<int>(time * frequency * (ratio + 1) * 400);
    const double h = time / steps;
    double x = 0.02;
    double v = 0;
    for (int i = 0; i < steps; ++i) {
        const double a1 = acceleration(x, v);
        const double a2 = acceleration(x + h / 2 * v, v + h / 2 * a1);
        const double a3 = acceleration(x + h / 2 * v + h * h / 4 * a1, v + h / 2 * a2);
        const double a4 = acceleration(x + h * v + h * h / 2 * a2, v + h * a3);
        x += h * v + h * h / 6 * (a1 + a2 + a3);
        v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return x;
}

Problem damping_problem(double ratio) {
    constexpr double youngs_modulus = 1e7;
    const double length = 2 * sphere_radius(edge * edge * edge);
    Problem problem = bare_problem("damping", 0.3, 10);
    SceneDescription& scene = problem.scene;
    scene.materials["rock"].youngs_modulus = youngs_modulus;
    scene.materials["rock"].normal_damping = 2 * length * ratio / edge;
    scene.shapes["cube"] = shipped_mesh("cube", edge);
    add_floor(scene);
    add_body(scene, "cube", Vec3(0, 0, edge / 2 + 0.02));
    const double frequency = std::sqrt(youngs_modulus * edge * edge / (length * 2600 * edge * edge * edge));
    problem.quantities = {"height"};
    problem.observe = [](const Simulation& simulation) {
        return Values{(simulation.file_motion(1).pose.position.z() - edge / 2) / edge};
    };
    const double end = fallen(ratio, frequency, scene.end_time) / edge;
    problem.model = [=](double) { return Values{end}; };
    problem.last_only = true;
    return problem;
}

}  // namespace

void add_contact_laws(std::vector<Extreme>& all, bool quick) {
    for (const double friction : {0.0, 1e-6, 0.5, 10.0, 1e6}) {
        all.push_back({"friction", cell(friction), friction_problem(friction), 5e-2});
    }
    for (const double ratio : {0.0, 0.01, 0.1, 1.0, 10.0, 100.0}) {
        if (!quick || ratio != 0.01) {
            all.push_back({"damping [critical]", cell(ratio), damping_problem(ratio), 5e-2});
        }
    }
}

}  // namespace scree
