// Cubes on one another that have nothing to do but stand, among them a light one under a heavy one.

#include <cmath>

#include "problem.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

constexpr double edge = 0.1;  // [m]

/// The heights [m] of the middles of cubes of these masses [kg], from below, where the law bears them.
std::vector<double> heights(const std::vector<double>& masses, double youngs_modulus) {
    std::vector<double> result;
    double top = 0;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        double load = 0;
        for (std::size_t above = i; above < masses.size(); ++above) {
            load += masses[above] * earth_gravity;
        }
        const double depth = sunk_depth(load, edge * edge * edge, edge * edge, youngs_modulus);
        result.push_back(top - depth + edge / 2);
        top = result.back() + edge / 2;
    }
    return result;
}

Values observe(const Simulation& simulation) {
    Values values;
    for (std::size_t i = 1; i < simulation.bodies().size(); ++i) {
        const Vec3 place = simulation.file_motion(i).pose.position / edge;
        values.insert(values.end(), {place.x(), place.y(), place.z()});
    }
    return values;
}

Values standing(const std::vector<double>& middles) {
    Values values;
    for (const double z : middles) {
        values.insert(values.end(), {0, 0, z / edge});
    }
    return values;
}

}  // namespace

Problem standing_cubes(const std::string& name, double end_time, double youngs_modulus,
                       const std::vector<double>& masses) {
    Problem problem = bare_problem(name, end_time, 20);
    SceneDescription& scene = problem.scene;
    scene.materials["rock"].youngs_modulus = youngs_modulus;
    scene.shapes["cube"] = shipped_mesh("cube", edge);
    add_floor(scene);
    const std::vector<double> middles = heights(masses, youngs_modulus);
    for (std::size_t i = 0; i < masses.size(); ++i) {
        const std::string material = "rock " + std::to_string(masses[i]);
        scene.materials[material] = scene.materials["rock"];
        scene.materials[material].density = masses[i] / (edge * edge * edge);
        add_body(scene, "cube", Vec3(0, 0, middles[i])).material = material;
        for (const char* axis : {"x", "y", "z"}) {
            problem.quantities.push_back(axis + (" of cube " + std::to_string(i + 1)));
        }
    }
    std::vector<double> rigid;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        rigid.push_back((static_cast<double>(i) + 0.5) * edge);
    }
    problem.observe = observe;
    problem.rigid = [values = standing(rigid)](double) { return values; };
    problem.model = [values = standing(middles)](double) { return values; };
    return problem;
}

Problem stack_problem(bool quick) {
    Problem problem = standing_cubes("stack", quick ? 2 : 10, 1e11, std::vector<double>(30, 2.6));
    problem.purpose =
        "Thirty cubes of 0.1 m stand on one another and nothing else happens: " +
        std::string(quick ? "two" : "ten") +
        " seconds. The error is the largest distance along an axis from where a cube would be if it were "
        "rigid, in edges; by the law the topmost sinks by some hundred-thousandths of an edge.";
    return problem;
}

Problem mass_ratio_problem() {
    Problem problem = standing_cubes("mass_ratio", 2, 1e11, {1, 1000});
    problem.purpose =
        "A cube of 1 kg bears one of 1000 kg for two seconds. The error is the largest distance along an "
        "axis from where a cube would be if it were rigid, in edges.";
    return problem;
}

}  // namespace scree
