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
    const double half = edge / 2;
    return {
        {"corner on corner",
         {{edge * 0.5 * (std::sqrt(3.0) + std::sqrt(3.0)) - 0.012, 0.002, 0.001}, diagonal},
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

/// Two cubes without friction and damping that meet corner to corner, off the line of centres: what is left
/// of their kinetic energy.
double kept(const std::string& law, bool backwards) {
    SceneDescription scene = parse_scene(R"({
        "gravity": [0, 0, 0],
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e8, "friction": 0, "normal_damping": 0}},
        "shapes": {"crate": {"box": [0.1, 0.1, 0.1]}},
        "bodies": [{"shape": "crate", "material": "rock", "position": [0, 0, 0]},
                   {"shape": "crate", "material": "rock", "position": [0.18, 0.012, 0.006],
                    "velocity": [-2, 0.1, 0]}],
        "law": {"normal": "volume"},
        "stepping": {"rtol": 1e-9, "atol": 1e-12, "max_order": 2},
        "end_time": 0.1, "output": {"every": 0.001}})",
                                         "corners.json", {"law.normal=" + law});
    scene.bodies[0].orientation = Quat::FromTwoVectors(Vec3(1, 1.1, 0.9), Vec3::UnitX());
    scene.bodies[1].orientation = Quat::FromTwoVectors(Vec3(1, 0.9, 1.2), -Vec3::UnitX());
    if (backwards) {
        scene.bodies[1].angular_velocity = {3, -8, 5};
    }
    Simulation simulation(scene);
    double start = 0;
    while (simulation.tick() < simulation.times().last()) {
        const bool good = simulation.advance();
        INFO(simulation.report().message);
        REQUIRE(good);
        start = start > 0 ? start : simulation.world().step_report().energy.kinetic;
    }
    REQUIRE(simulation.world().step_report().contacts == 0);
    return simulation.world().step_report().energy.kinetic / start;
}

}  // namespace

TEST_CASE(
    "The volume law makes or takes work round closed paths of corners and edges, the potential does not",
    "[laws]") {
    for (const Loop& loop : loops()) {
        CAPTURE(loop.name);
        const double by_volume = std::abs(work(loop, Elasticity::volume, 2000));
        const double by_potential = std::abs(work(loop, Elasticity::potential, 2000));
        std::printf("%-20s volume %.3e potential %.3e\n", loop.name, by_volume, by_potential);
        CHECK(by_volume > 1e-4);
        CHECK(by_potential < 1e-6);
    }
}

TEST_CASE("Two corners that meet lose or gain energy by the volume law and keep it by the potential",
          "[laws]") {
    for (const bool backwards : {false, true}) {
        CAPTURE(backwards);
        std::printf("kept: volume %.4f potential %.3e\n", kept("volume", backwards),
                    kept("energy", backwards) - 1);
        CHECK(std::abs(kept("volume", backwards) - 1) > 0.01);
        CHECK(std::abs(kept("energy", backwards) - 1) < 1e-6);
    }
}
