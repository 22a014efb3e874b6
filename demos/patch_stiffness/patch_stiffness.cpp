// What a tangential stiffness that knows the patch, (Yt/Lc)‖S‖, does beside the source's Yt Lc, Eq. (5.17):
// to the iterations of a pile's equations, to the longest step of an explicit method, and to the delay of
// friction. The source's exceeds the normal stiffness of a contact by far where two bodies touch with a
// corner.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <demos/table_and_picture.hpp>
#include <scree/scenes/friction_onset.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

namespace {

namespace fs = std::filesystem;

constexpr const char* stiffnesses[] = {"length", "patch"};

std::string icosahedron() {
    return std::string("{\"mesh\": \"") + SCREE_SOURCE_DIR + "/meshes/icosahedron.obj\", \"scale\": 0.05}";
}

// Icosahedra that fall into a box.
scree::SceneDescription pile(const std::string& stiffness) {
    return scree::parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e10, "friction": 0.5}},
        "shapes": {
            "floor": {"half_space": {"normal": [0, 0, 1]}},
            "left": {"half_space": {"normal": [1, 0, 0], "offset": -0.15}},
            "right": {"half_space": {"normal": [-1, 0, 0], "offset": -0.15}},
            "front": {"half_space": {"normal": [0, 1, 0], "offset": -0.15}},
            "back": {"half_space": {"normal": [0, -1, 0], "offset": -0.15}},
            "stone": )" + icosahedron() +
                                  R"(},
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "left", "material": "rock", "motion": "fixed"},
                   {"shape": "right", "material": "rock", "motion": "fixed"},
                   {"shape": "front", "material": "rock", "motion": "fixed"},
                   {"shape": "back", "material": "rock", "motion": "fixed"}],
        "fill": [{"shape": "stone", "material": "rock", "count": 27, "box": [[-0.15, -0.15, 0], [0.15, 0.15, 0.5]]}],
        "end_time": 0.5, "output": {"every": 0.02}
    })",
                              "pile.json", {"law.tangential_stiffness=" + stiffness});
}

void write_newton(const fs::path& file) {
    std::ofstream csv = table(file, "stiffness,steps,rejected,iterations_a_step,jacobians_a_step,residual");
    std::printf(
        "27 icosahedra fall into a box, Y = 1e10 Pa, rtol 1e-3, 0.5 s:\n%10s %8s %9s %12s %12s %14s\n",
        "stiffness", "steps", "repeated", "iterations", "Jacobians", "unexplained");
    for (const std::string stiffness : stiffnesses) {
        scree::Simulation simulation(pile(stiffness));
        while (simulation.tick() < simulation.times().last()) {
            if (!simulation.advance()) {
                throw std::runtime_error(simulation.report().message);
            }
        }
        const scree::SteppingStatistics& steps = simulation.report().steps;
        const auto accepted = static_cast<double>(steps.accepted);
        const std::size_t rejected = steps.rejected_error + steps.rejected_newton;
        const double iterations = static_cast<double>(steps.newton.iterations) / accepted;
        const double jacobians = static_cast<double>(steps.newton.jacobians) / accepted;
        const scree::EnergyLedger& energy = simulation.report().energy;
        const double residual = energy.residual / (energy.lost() + energy.kinetic);
        csv << stiffness << ',' << steps.accepted << ',' << rejected << ',' << iterations << ',' << jacobians
            << ',' << residual << "\n";
        std::printf("%10s %8zu %9zu %12.2f %12.2f %13.2f%%\n", stiffness.c_str(), steps.accepted, rejected,
                    iterations, jacobians, 100 * residual);
    }
}

// Whether the account of a stone that is thrown on the ground closes to a twentieth of its energy by explicit
// steps.
bool stays_stable(const std::string& shape, const std::string& stiffness, double step) {
    scree::SceneDescription scene = scree::parse_scene(
        R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e10, "friction": 0.5}},
        "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}}, "stone": )" +
            shape + R"(},
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "stone", "material": "rock", "position": [0, 0, 0.1], "orientation": [1, 0.2, 0.1, 0],
                    "velocity": [0.5, 0, 0]}],
        "stepping": {"method": "verlet", "step": 1}, "end_time": 0.6, "output": {"every": 0.1}})",
        "stone.json", {"law.tangential_stiffness=" + stiffness});
    scene.stepping.step = step;
    scree::Simulation simulation(scene);
    const double energy = simulation.bodies()[1].solid.volume * 2600 * 9.81 * 0.1;
    while (simulation.tick() < simulation.times().last()) {
        if (!simulation.advance() || !(std::abs(simulation.report().energy.residual) < 0.05 * energy)) {
            return false;
        }
    }
    return true;
}

double longest_step(const std::string& shape, const std::string& stiffness) {
    double stable = 1e-7;
    double unstable = 1e-3;
    while (unstable > 1.05 * stable) {
        const double middle = std::sqrt(stable * unstable);
        (stays_stable(shape, stiffness, middle) ? stable : unstable) = middle;
    }
    return stable;
}

void write_explicit(const fs::path& file) {
    std::ofstream csv = table(file, "shape,length,patch");
    std::printf(
        "\nThe longest step of velocity Verlet with which the energy of a thrown stone of Y = 1e10 Pa is "
        "accounted for [s]:\n%24s "
        "%10s %10s\n",
        "", "length", "patch");
    const std::pair<const char*, std::string> shapes[] = {{"cube", R"({"box": [0.1, 0.1, 0.1]})"},
                                                          {"ball", R"({"sphere": 0.05})"},
                                                          {"icosahedron", icosahedron()}};
    for (const auto& [name, shape] : shapes) {
        const double by_length = longest_step(shape, "length");
        const double by_patch = longest_step(shape, "patch");
        csv << name << ',' << by_length << ',' << by_patch << "\n";
        std::printf("%24s %10.1e %10.1e\n", name, by_length, by_patch);
    }
}

void write_delay(const fs::path& file) {
    std::ofstream csv = table(file, "damping,length,patch");
    std::printf("\nThe time until friction carries 95 %% of a tile's load, Y = 1e8 Pa [s]:\n%10s %10s %10s\n",
                "damping", "length", "patch");
    for (const double damping : {0.5, 1.0, 2.0}) {
        double delays[2] = {};
        for (const int i : {0, 1}) {
            scree::FrictionOnset onset;
            onset.tangential_damping = damping;
            onset.law.tangential_stiffness =
                i == 0 ? scree::TangentialStiffness::length : scree::TangentialStiffness::patch;
            delays[i] = scree::onset_delay(scree::run_friction_onset(onset, 2, 400), 0.95);
        }
        csv << damping << ',' << delays[0] << ',' << delays[1] << "\n";
        std::printf("%10.1f %10.2e %10.2e\n", damping, delays[0], delays[1]);
    }
}

}  // namespace

int main(int argc, char** argv) try {
    const fs::path out = argc > 1 ? argv[1] : "out/patch_stiffness";
    fs::create_directories(out);
    write_newton(out / "newton.csv");
    write_explicit(out / "explicit.csv");
    write_delay(out / "delay.csv");
    std::printf("\ntables: %s\n", out.c_str());
    return EXIT_SUCCESS;
} catch (const std::exception& error) {
    std::fprintf(stderr, "patch_stiffness: %s\n", error.what());
    return 2;
}
