// What the source warns of (5.3.4), measured: how long friction lags behind its load for a spring of some
// stiffness; what a vibrating floor leaves in the tangential springs; and how small bodies lose their static
// friction when the characteristic length is left out of the increment, Eq. (5.18). Writes three tables, and
// draws them where gnuplot is installed.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <string>

#include <demos/table_and_picture.hpp>
#include <scree/scenes/friction_onset.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

namespace {

namespace fs = std::filesystem;
using Settings = std::vector<std::string>;

constexpr double pi = std::numbers::pi;
constexpr double gravity = 9.81;

void advance(scree::Simulation& simulation) {
    if (!simulation.advance()) {
        throw std::runtime_error(simulation.report().message);
    }
}

// When the spring has 95 % of the load for good, by springs of length and of the patch, over √(m/kt) of the
// former.
void write_delay(const fs::path& file) {
    std::ofstream csv = table(file, "kt,damping,delay,in_periods");
    std::printf("Friction lags behind its load (time to 95 %% of it):\n%12s %8s %12s %16s\n", "kt [N/m]",
                "damping", "delay [s]", "delay/sqrt(m/kt)");
    for (const double damping : {0.5, 1.0, 2.0}) {
        for (int tenths = 70; tenths <= 110; tenths += 10) {
            scree::FrictionOnset onset;
            onset.youngs_modulus = std::pow(10, 0.1 * tenths);
            onset.tangential_damping = damping;
            const double frequency = scree::onset_frequency(onset);
            const double stiffness = frequency * frequency * scree::onset_mass();
            const double delay = scree::onset_delay(scree::run_friction_onset(onset, 2, 400), 0.95);
            csv << stiffness << ',' << damping << ',' << delay << ',' << delay * frequency << "\n";
            std::printf("%12.2e %8.1f %12.2e %16.3f\n", stiffness, damping, delay, delay * frequency);
        }
    }
}

// A box on a floor that shakes sideways and up and down, below the acceleration that would lift it or let it
// slip.
double spring_energy(const std::string& direction, double acceleration, const Settings& more) {
    constexpr double frequency = 50;
    scree::SceneDescription scene = scree::parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e8, "friction": 0.5}},
        "shapes": {"crate": {"box": [0.1, 0.08, 0.06]}, "slab": {"box": [1, 1, 0.1]}},
        "bodies": [{"name": "floor", "shape": "slab", "material": "rock", "position": [0, 0, -0.05],
                    "motion": {"velocity": )" + direction + R"(, "amplitude": 1e-5, "frequency": 50}},
                   {"shape": "crate", "material": "rock", "position": [0, 0, 0.03]}],
        "stepping": {"rtol": 1e-4, "atol": 1e-8}, "end_time": 1, "output": {"every": 0.0013}})",
                                                       "floor.json", more);
    auto& motion = std::get<scree::PrescribedMotion>(scene.bodies[0].motion);
    motion.amplitude = acceleration * gravity / std::pow(2 * pi * frequency, 2);
    scree::Simulation simulation(scene);
    double sum = 0;
    int count = 0;
    while (simulation.tick() < simulation.times().last()) {
        advance(simulation);
        if (simulation.tick() > simulation.times().last() / 2) {
            const scree::EnergyLedger& energy = simulation.world().step_report().energy;
            sum += energy.tangential_elastic + energy.torsional_elastic;
            ++count;
        }
    }
    return sum / count;
}

void write_noise(const fs::path& file) {
    std::ofstream csv = table(file, "acceleration,sideways,sideways_undamped,aslant,steady");
    // What the spring holds on average when it carries the box through it: ½ (m a)²/kt/2.
    const double mass = 2600 * 0.1 * 0.08 * 0.06;
    const double radius = std::cbrt(3 / (4 * pi) * 0.1 * 0.08 * 0.06);
    const double stiffness = 2.0 / 7 * 1e8 * 2 * radius;
    std::printf(
        "\nWhat a floor that shakes at 50 Hz leaves in the tangential springs [J]:\n%14s %12s %12s %12s "
        "%12s\n",
        "acceleration/g", "sideways", "undamped", "aslant", "carried load");
    for (const double acceleration : {0.05, 0.1, 0.2, 0.3, 0.4}) {
        const double sideways = spring_energy("[1, 0, 0]", acceleration, {});
        const double undamped =
            spring_energy("[1, 0, 0]", acceleration, {"materials.rock.tangential_damping=0"});
        const double aslant = spring_energy("[1, 0, 1]", std::sqrt(2.0) * acceleration, {});
        const double steady = std::pow(mass * acceleration * gravity, 2) / (4 * stiffness);
        csv << acceleration << ',' << sideways << ',' << undamped << ',' << aslant << ',' << steady << "\n";
        std::printf("%14.2f %12.3e %12.3e %12.3e %12.3e\n", acceleration, sideways, undamped, aslant, steady);
    }
}

struct Creep {
    double way = 0;   // over the edge, in a second
    double slip = 0;  // share of the output times at which the contact was at its limit
};

// A cube on a slope of half its friction's, stepped explicitly with a fortieth of its own period.
scree::SceneDescription creep_scene(double edge, const std::string& stiffness) {
    const double modulus = 1e7;
    const double mass = 2600 * std::pow(edge, 3);
    const double length = 2 * std::cbrt(3 / (4 * pi)) * edge;
    const double step = 2 * pi * std::sqrt(mass * length / (modulus * edge * edge)) / 40;
    scree::SceneDescription scene =
        scree::parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e7, "friction": 0.5}},
        "shapes": {"crate": {"box": [1, 1, 1]}, "floor": {"half_space": {"normal": [0, 0, 1]}}},
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "crate", "material": "rock"}],
        "end_time": 1})",
                           "creep.json", {"law.tangential_stiffness=" + stiffness});
    scene.gravity = gravity * scree::Vec3(0.25, 0, -1).normalized();
    scene.shapes["crate"] = scree::BoxShape{scree::Vec3::Constant(edge)};
    scene.bodies[1].position.z() = edge / 2 - mass * gravity * length / (modulus * edge * edge);
    scene.stepping.method = scree::SteppingMethod::verlet;
    scene.stepping.step = step;
    scene.end_time = 4000 * step;
    scene.output.every = 20 * step;
    return scene;
}

Creep creep(double edge, const std::string& stiffness) {
    scree::Simulation simulation(creep_scene(edge, stiffness));
    Creep creep;
    scree::Vec3 middle = scree::Vec3::Zero();
    while (simulation.tick() < simulation.times().last()) {
        advance(simulation);
        const auto results = simulation.world().contact_results();
        if (simulation.tick() == simulation.times().last() / 2) {
            middle = simulation.body_motion(1).pose.position;
        }
        creep.slip += !results.empty() && results[0].law.state == scree::ContactState::slip ? 1.0 / 200 : 0;
    }
    const scree::Vec3 way = simulation.body_motion(1).pose.position - middle;
    creep.way = way.head<2>().norm() / edge / (simulation.scene().end_time / 2);
    return creep;
}

void write_length(const fs::path& file) {
    std::ofstream csv = table(file, "edge,way_with,slip_with,way_without,slip_without");
    std::printf(
        "\nA cube on a slope of half its friction's, with Lc in the increment, Eq. (5.17), and without, "
        "(5.18),\n"
        "in explicit steps: its way over its edge in a second, and how often it was at its limit:\n"
        "%10s %14s %10s %14s %10s\n",
        "edge [m]", "way, with", "slip", "way, without", "slip");
    for (const double edge : {1.0, 0.1, 0.01, 0.001}) {
        const Creep with = creep(edge, "length");
        const Creep without = creep(edge, "no_length");
        csv << edge << ',' << with.way << ',' << with.slip << ',' << without.way << ',' << without.slip
            << "\n";
        std::printf("%10g %14.3e %9.0f%% %14.3e %9.0f%%\n", edge, with.way, 100 * with.slip, without.way,
                    100 * without.slip);
    }
}

}  // namespace

int main(int argc, char** argv) try {
    const fs::path out = argc > 1 ? argv[1] : "out/caveats";
    fs::create_directories(out);
    write_delay(out / "delay.csv");
    write_noise(out / "noise.csv");
    write_length(out / "length.csv");
    std::printf("\ntables: %s\n", out.c_str());
    draw("caveats", out);
    return EXIT_SUCCESS;
} catch (const std::exception& error) {
    std::fprintf(stderr, "caveats: %s\n", error.what());
    return 2;
}
