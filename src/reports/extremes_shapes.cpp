// Slivers, meshes of few and of many faces, high stacks, and contacts that are exactly aligned.

#include <cmath>

#include "scene_parts.hpp"
#include "stability.hpp"

namespace scree {

namespace {

Values lowest_and_fastest(const Simulation& simulation) {
    double lowest = 1;
    double fastest = 0;
    for (std::size_t i = 0; i < simulation.bodies().size(); ++i) {
        if (simulation.bodies()[i].dynamic()) {
            const FrameMotion now = simulation.body_motion(i);
            lowest = std::min(lowest, bounds(*simulation.bodies()[i].solid.shape, now.pose).low.z() / 0.1);
            fastest = std::max(fastest, now.velocity.norm());
        }
    }
    return {lowest, fastest};
}

/// Cubes of 0.1 m at whole places of a grid, each exactly in touch with its neighbours: all stay.
Problem bricks(int wide, int high) {
    Problem problem = bare_problem("bricks", 1, 10);
    SceneDescription& scene = problem.scene;
    scene.shapes["cube"] = shipped_mesh("cube", 0.1);
    add_floor(scene);
    for (int z = 0; z < high; ++z) {
        for (int y = 0; y < wide; ++y) {
            for (int x = 0; x < wide; ++x) {
                add_body(scene, "cube", Vec3(0.1 * x, 0.1 * y, 0.05 + 0.1 * z));
            }
        }
    }
    problem.quantities = {"lowest point", "speed"};
    problem.observe = lowest_and_fastest;
    problem.model = [](double) { return Values{0, 0}; };
    problem.last_only = true;
    return problem;
}

/// Two cubes that meet edge on edge, exactly parallel or nearly so, without gravity and damping: what they
/// had of energy they keep.
Problem parallel_edges(double twist) {
    Problem problem = bare_problem("edges", 0.05, 10);
    SceneDescription& scene = problem.scene;
    scene.gravity.setZero();
    MaterialDescription& rock = scene.materials["rock"];
    rock.friction = rock.normal_damping = rock.tangential_damping = 0;
    rock.youngs_modulus = 1e9;
    scene.shapes["cube"] = shipped_mesh("cube", 0.1);
    const Quat quarter(Eigen::AngleAxisd(std::atan(1.0), Vec3::UnitX()));
    add_body(scene, "cube", Vec3::Zero()).orientation = quarter;
    BodyDescription& other = add_body(scene, "cube", Vec3(0.01, 0, 0.1 * std::sqrt(2.0) + 0.01));
    other.orientation = Quat(Eigen::AngleAxisd(twist, Vec3::UnitZ())) * quarter;
    other.velocity.z() = -1;
    problem.quantities = {"energy", "momentum"};
    problem.observe = [](const Simulation& simulation) {
        const EnergyLedger& energy = simulation.report().energy;
        const double whole = 0.5 * 10 * 0.1 * 0.1 * 0.1 * 260;  // of 2.6 kg at 1 m/s [J]
        const Vec3 momentum = simulation.body_motion(0).velocity + simulation.body_motion(1).velocity;
        return Values{energy.kinetic / whole, momentum.z()};
    };
    problem.model = [](double) { return Values{1, -1}; };
    problem.last_only = true;
    return problem;
}

void add_slivers(std::vector<Extreme>& all) {
    for (const double aspect : {1e2, 1e4}) {
        Settling settling;
        settling.edge = 1;
        settling.youngs_modulus = 1e10;
        settling.shape = BoxShape{Vec3(1, 1, 1 / aspect)};
        all.push_back({"sliver plate", cell(aspect), settling_problem(settling)});
        settling.shape = BoxShape{Vec3(1, 1 / aspect, 1 / aspect)};
        all.push_back({"sliver needle", cell(aspect), settling_problem(settling)});
    }
}

/// Bodies of few faces and of many.
void add_faces(std::vector<Extreme>& all, const std::filesystem::path& folder) {
    for (const char* mesh : {"tetrahedron", "icosahedron"}) {
        Settling settling;
        settling.shape = shipped_mesh(mesh, settling.edge);
        all.push_back(
            {"faces", mesh == std::string("tetrahedron") ? "4" : "20", settling_problem(settling), 0.3});
    }
    for (const int points : {100, 2502}) {
        Settling settling;
        MeshShape stone;
        stone.file = std::filesystem::absolute(write_round_stone(folder, points));
        stone.scale = Vec3::Constant(settling.edge);
        settling.shape = stone;
        all.push_back({"faces", std::to_string(2 * points - 4), settling_problem(settling), 0.3});
    }
}

Extreme stack_of(int count, double end_time) {
    const std::vector<double> masses(static_cast<std::size_t>(count), 2.6);
    return {"stack", std::to_string(count), standing_cubes("stack", end_time, 1e11, masses), 1e-4};
}

}  // namespace

void add_shapes(std::vector<Extreme>& all, const std::filesystem::path& folder, bool quick) {
    add_slivers(all);
    add_faces(all, folder);
    all.push_back(stack_of(30, 1));
    all.push_back(stack_of(100, quick ? 0.2 : 1));
    for (const double ratio : {1e3, 1e6, 1e9}) {
        all.push_back(
            {"mass ratio", cell(ratio), standing_cubes("mass_ratio", 1, 1e12, {1e-3, 1e-3 * ratio}), 1e-4});
    }
    all.push_back({"aligned", "cube on cube", bricks(1, 2)});
    all.push_back({"aligned", "coplanar sides", bricks(2, 2)});
    all.push_back({"aligned", "parallel edges", parallel_edges(0), 0.05});
    all.push_back({"aligned", "edges 1e-9 rad from parallel", parallel_edges(1e-9), 0.05});
}

}  // namespace scree
