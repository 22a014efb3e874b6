// Every choice of the contact law beside the closed form that it is known by: one small scene each.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numbers>
#include <stdexcept>
#include <string>

#include <scree/scenes/find_scene.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

namespace {

using scree::Quat;
using scree::SceneDescription;
using scree::Simulation;
using scree::Vec3;
using Settings = std::vector<std::string>;

constexpr double pi = std::numbers::pi;
constexpr double gravity = 9.81;
constexpr double radius = 0.05;
double worst = 0;

// A floor and a second body of one of the shapes.
SceneDescription scene(const std::string& shape, const Settings& settings) {
    SceneDescription description = scree::parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e9, "friction": 0.5}},
        "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}}, "ball": {"sphere": 0.05},
                   "cube": {"box": [0.1, 0.1, 0.1]}, "tile": {"box": [0.2, 0.1, 0.05]}},
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "cube", "material": "rock"}],
        "stepping": {"rtol": 1e-6, "atol": 1e-9}, "end_time": 1, "output": {"every": 0.001}})",
                                                      "table.json", settings);
    description.bodies[1].shape = shape;
    description.bodies[1].position.z() = shape == "tile" ? 0.025 : radius;
    return description;
}

void advance(Simulation& simulation, double duration) {
    for (int i = 0; i < std::lround(duration / simulation.scene().output.every); ++i) {
        if (!simulation.advance()) {
            throw std::runtime_error(simulation.report().message);
        }
    }
}

void row(const char* what, const char* form, double expected, double measured) {
    const double error = std::abs(measured / expected - 1);
    worst = std::max(worst, error);
    std::printf("%-52s %-34s %12.6g %12.6g %9.1e\n", what, form, expected, measured, error);
}

void add_friction() {
    SceneDescription thrown =
        scene("tile", {"materials.rock.kinetic_friction=0.4", "materials.rock.friction=0.6"});
    thrown.bodies[1].velocity.x() = 1;
    Simulation kinetic(thrown);
    advance(kinetic, 0.5);
    row("kinetic friction: a block thrown at 1 m/s stops [m]", "v²/(2 μk g)", 1 / (0.8 * gravity),
        kinetic.body_motion(1).pose.position.x());

    SceneDescription sticky = scene("tile", {"law.friction=viscous", "materials.rock.friction=10"});
    sticky.gravity = gravity * Vec3(0.2, 0, -1).normalized();
    Simulation viscous(sticky);
    advance(viscous, 0.5);
    const double before = viscous.body_motion(1).pose.position.x();
    advance(viscous, 0.5);
    const double mass = 2600 * 0.2 * 0.1 * 0.05;
    const double length = 2 * std::cbrt(3 / (4 * pi) * 1e-3);
    const double damping = 0.5 * std::sqrt(2.0 / 7 * 1e9 * mass * length);
    row("viscous friction: a block creeps downhill [m/s]", "m g sin θ/(γt √(Yt m Lc))",
        mass * sticky.gravity.x() / damping, (viscous.body_motion(1).pose.position.x() - before) / 0.5);
}

void add_rolling() {
    SceneDescription rolled =
        scene("ball", {"materials.rock.rolling_friction=0.1", "materials.rock.youngs_modulus=1e11",
                       "materials.rock.normal_damping=1", "law.normal_damping=patch"});
    rolled.bodies[1].velocity.x() = 0.5;
    rolled.bodies[1].angular_velocity.y() = 10;
    Simulation simulation(rolled);
    advance(simulation, 1);
    row("rolling resistance: a ball rolled at 0.5 m/s stops [m]", "7 v²/(10 μr g)",
        0.7 * 0.25 / (0.1 * gravity), simulation.body_motion(1).pose.position.x());
}

void add_cohesion() {
    const double weight = 2600 * 4.0 / 3 * pi * std::pow(radius, 3) * gravity;
    SceneDescription hanging =
        scene("ball", {"shapes.floor.half_space.normal=[0,0,-1]", "law.normal_damping=patch"});
    hanging.materials.at("rock").cohesion = 2 * weight;
    const double volume = weight * 2 * radius / 1e9;
    double depth = std::sqrt(volume / (pi * radius));
    for (int i = 0; i < 20; ++i) {
        depth = std::sqrt(volume / (pi * (radius - depth / 3)));
    }
    hanging.bodies[1].position.z() = -radius + 0.8 * depth;
    Simulation simulation(hanging);
    advance(simulation, 0.5);
    row("cohesion of two weights: a ball hangs, sunk in by [m]", "Y V(δ)/Lc = F − m g", depth,
        simulation.body_motion(1).pose.position.z() + radius);
}

void add_spin() {
    for (const std::string torsion : {"true", "\"patch\""}) {
        SceneDescription spun = scene("cube", {"materials.rock.torsion=" + torsion});
        spun.bodies[1].angular_velocity.z() = 5;
        Simulation simulation(spun);
        advance(simulation, 0.04);
        const double left = simulation.body_motion(1).angular_velocity.z();
        const std::string what = "torsion " + torsion + ": a cube spun at 5 rad/s stops [s]";
        row(what.c_str(), "a² ω/(6 μ g r̄), r̄ = 0.38260 a", 0.1 * 5 / (3 * gravity * 0.38260),
            0.2 / (5 - left));
    }
}

// v and R ω [m/s] of the disc when they have fallen to some thousandths.
std::array<double, 4> disc(const std::string& torsion) {
    SceneDescription thrown = scree::read_scene(
        scree::find_scene("spinning_disc"),
        {"materials.rock.torsion=" + torsion, "output.every=0.0001", "materials.rock.youngs_modulus=1e11"});
    thrown.bodies[1].velocity.x() = 0.6;
    thrown.bodies[1].angular_velocity.z() = 10;
    Simulation simulation(thrown);
    std::array<double, 4> seen{};
    advance(simulation, 0.02);
    const auto look = [&](std::size_t i) {
        seen[i] = simulation.body_motion(1).velocity.norm();
        seen[i + 1] = 0.1 * simulation.body_motion(1).angular_velocity.z();
    };
    look(0);
    while (0.1 * simulation.body_motion(1).angular_velocity.z() > 0.003) {
        look(2);
        advance(simulation, 0.0001);
    }
    return seen;
}

void add_disc() {
    const auto on_cells = disc("\"patch\"");
    row("torsion \"patch\": a disc slides and spins to its stop", "v/(R ω) = 0.653", 0.653,
        on_cells[2] / on_cells[3]);
    const auto on_surface = disc("true");
    row("torsion true: the same, as a power of ω", "9/8", 9.0 / 8,
        std::log(on_surface[2] / on_surface[0]) / std::log(on_surface[3] / on_surface[1]));
}

// Two cubes that meet with their upright edges and slide off one another: the kinetic energy that is left,
// without damping and friction.
double kept(const std::string& law) {
    SceneDescription corners = scree::parse_scene(R"({
        "gravity": [0, 0, 0],
        "materials": {"rock": {"density": 2600, "youngs_modulus": 3e7, "friction": 0, "normal_damping": 0}},
        "shapes": {"cube": {"box": [0.1, 0.1, 0.1]}},
        "bodies": [{"shape": "cube", "material": "rock"},
                   {"shape": "cube", "material": "rock", "position": [0.16, -0.045, 0], "velocity": [-2, 1.5, 0]}],
        "stepping": {"rtol": 1e-8, "atol": 1e-11}, "end_time": 0.2, "output": {"every": 0.002}})",
                                                  "corners.json", {"law.normal=" + law});
    corners.bodies[0].orientation = Quat(Eigen::AngleAxisd(pi / 4, Vec3::UnitZ()));
    corners.bodies[1].orientation = Quat(Eigen::AngleAxisd(25 * pi / 180, Vec3::UnitZ()));
    Simulation simulation(corners);
    advance(simulation, 0.002);
    const double start = simulation.world().step_report().energy.kinetic;
    advance(simulation, 0.198);
    return simulation.world().step_report().energy.kinetic / start;
}

void add_energy() {
    row("normal \"energy\": corner on corner keeps its energy", "1", 1, kept("energy"));
    std::printf("%-52s %-34s %12s %12.6g\n", "normal \"volume\": the same", "none", "", kept("volume"));
}

// The restitution of a ball and of a cube on its corner by the damping whose ratio is the same everywhere.
void add_restitution() {
    const auto bounce = [](const std::string& shape) {
        SceneDescription falling =
            scene(shape, {"law.normal_damping=patch", "materials.rock.normal_damping=0.4",
                          "materials.rock.friction=0", "gravity=[0,0,0]"});
        if (shape == "cube") {
            falling.bodies[1].orientation = Quat::FromTwoVectors(Vec3(1, 1, 1), -Vec3::UnitZ());
        }
        falling.bodies[1].position.z() = 1e-4 + (shape == "cube" ? 0.05 * std::sqrt(3.0) : radius);
        falling.bodies[1].velocity.z() = -1;
        Simulation simulation(falling);
        advance(simulation, 0.05);
        return simulation.body_motion(1).velocity.z();
    };
    const auto restitution = [](double power) {
        const double ratio = 0.2 * std::sqrt(2 * power / (power + 1));
        return std::exp(-2 * ratio / std::sqrt(1 - ratio * ratio) * std::acos(ratio));
    };
    row("normal damping \"patch\", ζ = 0.2: a ball bounces", "e(ζ √(2p/(p+1))), p = 2", restitution(2),
        bounce("ball"));
    row("the same: a cube on its corner bounces", "p = 3", restitution(3), bounce("cube"));
}

}  // namespace

int main() try {
    std::printf("%-52s %-34s %12s %12s %9s\n", "what", "closed form", "expected", "measured", "error");
    add_friction();
    add_rolling();
    add_cohesion();
    add_spin();
    add_disc();
    add_energy();
    add_restitution();
    std::printf("worst error %.1e\n", worst);
    return worst < 0.01 ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const std::exception& error) {
    std::fprintf(stderr, "law_table: %s\n", error.what());
    return 2;
}
