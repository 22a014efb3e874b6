// What the normal laws do round closed paths and in collisions: work that comes from nowhere.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/contact/built_in_law.hpp>
#include <scree/dynamics/contact_forces.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double edge = 0.1;

/// Two cubes that meet, and a closed path of A about where it starts.
struct Loop {
    const char* name;
    Pose a;
    Vec3 swing, sway;         // [m], at the angles sin and cos
    Vec3 turn_one, turn_two;  // [rad]

    [[nodiscard]] Pose at(double angle) const {
        const double s = std::sin(angle);
        const double c = std::cos(angle) - 1;
        const Vec3 turn = s * turn_one + c * turn_two;
        const double size = turn.norm();
        const Quat rotation = size > 0 ? Quat(Eigen::AngleAxisd(size, turn / size)) : Quat::Identity();
        return {a.position + s * swing + c * sway, rotation * a.orientation};
    }
};

Quat turned(double angle, const Vec3& axis) {
    return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

std::vector<Loop> loops() {
    const Quat diagonal = Quat::FromTwoVectors(Vec3(1, 1, 1), -Vec3::UnitX());
    return {
        {"corner on corner",
         {{edge * 0.5 * (std::sqrt(3.0) + std::sqrt(3.0)) - 0.02, 0.002, 0.001}, diagonal},
         {0.002, 0.003, 0},
         {0, 0.002, 0.004},
         {0.05, 0, 0.08},
         {0, 0.1, 0.03}},
        {"edge on edge",
         {{edge * std::sqrt(2.0) - 0.006, 0.004, 0.003},
          turned(pi / 2, Vec3::UnitX()) * turned(pi / 4, Vec3::UnitZ())},
         {0.002, 0.001, 0},
         {0, 0.003, 0.002},
         {0.05, 0.1, 0},
         {0.1, 0, 0.02}},
        {"face over an edge",
         {{0.06, 0.01, edge - 0.001}, Quat::Identity()},
         {0.02, 0, 0.0002},
         {0.01, 0.002, 0.0003},
         {0, 0.003, 0.01},
         {0.002, 0, 0}},
    };
}

// The other cube, so that a loop's kind of feature looks at A.
Pose other(const Loop& loop) {
    if (std::string(loop.name) == "corner on corner") {
        return {Vec3::Zero(), Quat::FromTwoVectors(Vec3(1, 1, 1), Vec3::UnitX())};
    }
    if (std::string(loop.name) == "edge on edge") {
        return {Vec3::Zero(), turned(pi / 4, Vec3::UnitZ())};
    }
    return {};
}

/// ∮ F·dx + M·dθ over ∮ |F·dx + M·dθ|: what a loop makes of what goes in and out.
double work(const Loop& loop, Elasticity elasticity, int parts) {
    const Shape cube = make_box(Vec3::Constant(edge));
    LawOptions options;
    options.elasticity = elasticity;
    const ForcesOf forces(BuiltInLaw<LawParts{FrictionLaw::none, false, false}>{options});
    std::vector<Contact> contacts(1);
    contacts[0].a = {0, &cube, {}};
    contacts[0].b = {1, &cube, {}};
    contacts[0].pair = pair_constants({1e7, 0, 0, 0, 2.0 / 7, false}, {1, 0.06}, {1, 0.06});
    std::vector<ContactResult> results(1);
    std::vector<TrialBody> bodies(2);
    bodies[1].pose = other(loop);
    double sum = 0;
    double size = 0;
    for (int i = 0; i < parts; ++i) {
        const double angle = 2 * pi * i / parts;
        const double step = 1e-4;
        bodies[0].pose = loop.at(angle);
        forces.evaluate(contacts, bodies, {}, Detail::force, results);
        REQUIRE(results[0].touching);
        const Pose before = loop.at(angle - step);
        const Pose after = loop.at(angle + step);
        const Quat turn = after.orientation * before.orientation.conjugate();
        const Vec3 moved = (after.position - before.position) / (2 * step);
        const Vec3 turned_by = 2 * (turn.w() < 0 ? -1 : 1) * turn.vec() / (2 * step);
        const double power = results[0].law.force.dot(moved) + results[0].moment_a.dot(turned_by);
        sum += power;
        size += std::abs(power);
    }
    return sum / size;
}

/// Two cubes without friction and damping that meet with their upright edges and slide off one another.
SceneDescription collision(const std::string& law) {
    SceneDescription scene = parse_scene(R"({
        "gravity": [0, 0, 0],
        "materials": {"rock": {"density": 2600, "youngs_modulus": 3e7, "friction": 0, "normal_damping": 0}},
        "shapes": {"crate": {"box": [0.1, 0.1, 0.1]}},
        "bodies": [{"shape": "crate", "material": "rock"},
                   {"shape": "crate", "material": "rock", "position": [0.16, -0.045, 0],
                    "velocity": [-2, 1.5, 0]}],
        "stepping": {"rtol": 1e-8, "atol": 1e-11},
        "end_time": 0.2, "output": {"every": 0.002}})",
                                         "corners.json", {"law.normal=" + law});
    scene.bodies[0].orientation = turned(pi / 4, Vec3::UnitZ());
    scene.bodies[1].orientation = turned(25 * pi / 180, Vec3::UnitZ());
    return scene;
}

struct Outcome {
    double share = 0;               // of the kinetic energy that is left
    double residual = 0;            // of the account, over that energy
    std::vector<FrameMotion> last;  // how the cubes move then
};

Outcome collide(const SceneDescription& scene) {
    Simulation simulation(scene);
    double start = 0;
    while (simulation.tick() < simulation.times().last()) {
        const bool good = simulation.advance();
        INFO(simulation.report().message);
        REQUIRE(good);
        start = start > 0 ? start : simulation.world().step_report().energy.kinetic;
    }
    const StepReport& report = simulation.world().step_report();
    REQUIRE(report.contacts == 0);
    return {report.energy.kinetic / start,
            std::abs(report.energy.residual) / start,
            {simulation.file_motion(0), simulation.file_motion(1)}};
}

// From where a collision has ended back to where it began.
SceneDescription reversed(SceneDescription scene, const Outcome& outcome) {
    for (std::size_t b = 0; b < 2; ++b) {
        scene.bodies[b].position = outcome.last[b].pose.position;
        scene.bodies[b].orientation = outcome.last[b].pose.orientation;
        scene.bodies[b].velocity = -outcome.last[b].velocity;
        scene.bodies[b].angular_velocity = -outcome.last[b].angular_velocity;
    }
    return scene;
}

}  // namespace

TEST_CASE(
    "The volume law makes or takes work round closed paths of corners and edges, the potential does not",
    "[laws]") {
    for (const Loop& loop : loops()) {
        CAPTURE(loop.name);
        const double by_volume = std::abs(work(loop, Elasticity::volume, 2000));
        const double by_potential = std::abs(work(loop, Elasticity::potential, 2000));
        CAPTURE(by_volume, by_potential);
        CHECK(by_volume > 1e-4);
        CHECK(by_potential < 1e-6);
    }
}

TEST_CASE(
    "Two corners that meet lose energy by the volume law, gain it back the other way, and keep it by a "
    "potential",
    "[laws]") {
    const SceneDescription by_volume = collision("volume");
    const Outcome there = collide(by_volume);
    const Outcome back = collide(reversed(by_volume, there));
    CHECK(there.share < 0.93);
    CHECK(back.share > 1.07);
    CHECK(there.share * back.share == Approx(1).epsilon(1e-5));
    const SceneDescription by_potential = collision("energy");
    const Outcome kept = collide(by_potential);
    CHECK(std::abs(kept.share - 1) < 1e-6);
    CHECK(std::abs(collide(reversed(by_potential, kept)).share - 1) < 1e-6);
    CHECK(kept.residual < 1e-6);
}

TEST_CASE("Explicit methods keep the energy of corners by a potential, too, better the smaller the step",
          "[laws]") {
    const auto error = [](double step) {
        SceneDescription scene = collision("energy");
        scene.stepping.method = SteppingMethod::verlet;
        scene.stepping.step = step;
        return std::abs(collide(scene).share - 1);
    };
    CHECK(error(1e-5) < 1e-5);
    CHECK(error(1e-6) < 1e-6);
}

TEST_CASE("A stack of cubes stands by the potential as by the volume law, also in a hurry", "[laws]") {
    for (const std::string method : {"bdf", "verlet"}) {
        CAPTURE(method);
        SceneDescription scene = parse_scene(R"({
            "materials": {"rock": {"density": 2600, "youngs_modulus": 1e9, "friction": 0.5}},
            "shapes": {"crate": {"box": [0.1, 0.1, 0.1]}, "slab": {"box": [1, 1, 0.2]}},
            "bodies": [{"shape": "slab", "material": "rock", "position": [0, 0, -0.1], "motion": "fixed"}],
            "law": {"normal": "energy"}, "end_time": 0.5})",
                                             "stack.json");
        if (method == "verlet") {
            scene.stepping.method = SteppingMethod::verlet;
            scene.stepping.step = 1e-5;
            scene.end_time = 0.1;
        }
        for (int i = 0; i < 5; ++i) {
            BodyDescription cube;
            cube.shape = "crate";
            cube.material = "rock";
            cube.position = {0.002 * i, -0.001 * i, 0.05 + 0.1 * i};
            scene.bodies.push_back(cube);
        }
        Simulation simulation(scene);
        while (simulation.tick() < simulation.times().last()) {
            const bool good = simulation.advance();
            INFO(simulation.report().message);
            REQUIRE(good);
        }
        for (std::size_t b = 1; b < simulation.bodies().size(); ++b) {
            CHECK((simulation.file_motion(b).pose.position - scene.bodies[b].position).norm() < 1e-5);
        }
    }
}
