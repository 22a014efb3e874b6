// The scenes that come with scree do what their first comment says.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/scenes/find_scene.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

SceneDescription shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
    return read_scene(find_scene(name), settings);
}

void run(Simulation& simulation) {
    while (simulation.tick() < simulation.times().last()) {
        const bool good = simulation.advance();
        INFO(simulation.report().message);
        REQUIRE(good);
    }
}

}  // namespace

TEST_CASE("Every scene that comes with scree loads and says its purpose") {
    const std::vector<ShippedScene> scenes = shipped_scenes();
    for (const char* name : {"arch", "conveyor", "drum", "hopper", "incline", "packing", "pile", "repose",
                             "sphere_heap", "stack", "tower", "vibrating_plate", "wall"}) {
        CHECK(
            std::any_of(scenes.begin(), scenes.end(), [&](const auto& scene) { return scene.name == name; }));
    }
    for (const ShippedScene& scene : scenes) {
        CAPTURE(scene.name);
        CHECK(scene.purpose.size() > 20);
        CHECK_NOTHROW(Simulation(read_scene(scene.file)));
    }
}

TEST_CASE("The stack stands: no drift of a millionth of an edge, and each face bears what is above it") {
    Simulation simulation(shipped("stack"));
    run(simulation);
    constexpr double edge = 0.1;
    constexpr double cubes = 30;
    for (std::size_t b = 1; b < simulation.bodies().size(); ++b) {
        CAPTURE(b);
        const Vec3 start = simulation.bodies()[b].start.pose.position;
        CHECK((simulation.file_motion(b).pose.position - start).norm() < 1e-6 * edge);
    }
    // m g Lc/(Y A) for each weight above, Lc the diameter of the sphere of a cube's volume, Eqs. (5.3) and
    // (5.7).
    const double diameter = 2 * std::cbrt(3 / (4 * std::numbers::pi)) * edge;
    const double sinking = 2600 * std::pow(edge, 3) * 9.81 * diameter / (1e9 * edge * edge);
    for (std::size_t b = 1; b < simulation.bodies().size(); ++b) {
        const double height = simulation.file_motion(b).pose.position.z();
        const double below = b == 1 ? -edge / 2 : simulation.file_motion(b - 1).pose.position.z();
        const double weights = cubes - static_cast<double>(b) + 1;
        CHECK(below + edge - height == Approx(weights * sinking).epsilon(1e-2).margin(1e-8 * edge));
    }
}

TEST_CASE("The drum lifts its stones and loses the work that it does", "[.long]") {
    Simulation simulation(shipped("drum"));
    run(simulation);
    const EnergyLedger& energy = simulation.report().energy;
    const double lost = energy.lost();
    CHECK(energy.work_applied > 0);
    CHECK(std::abs(energy.residual) < 0.05 * lost);
    Vec3 centre = Vec3::Zero();
    double stones = 0;
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
        if (simulation.bodies()[b].dynamic()) {
            const Vec3 position = simulation.body_motion(b).pose.position;
            CHECK(std::hypot(position.x(), position.z()) < 0.2 / std::cos(std::numbers::pi / 16));
            centre += position;
            ++stones;
        }
    }
    // The drum turns about y, z towards x: what it carries up is at negative x.
    CHECK(centre.x() / stones < -0.02);
    CHECK(centre.z() / stones < -0.08);
}

TEST_CASE("The heap of balls stays higher than a layer of them", "[.long]") {
    Simulation simulation(shipped("sphere_heap"));
    run(simulation);
    double highest = 0;
    std::size_t on_tray = 0;
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
        if (!simulation.bodies()[b].dynamic()) {
            continue;
        }
        const FrameMotion motion = simulation.body_motion(b);
        if (motion.pose.position.z() > 0.1) {
            highest = std::max(highest, motion.pose.position.z());
            ++on_tray;
        }
    }
    CHECK(on_tray > 150);
    CHECK(highest > 0.1 + 3 * 0.016);  // over the centres of a layer of the smallest
}

// The stack starts in balance, and its residual is rounding at any tolerance.
TEST_CASE("The ledger's residual falls with the tolerance where bodies fall, collide and are turned",
          "[.long]") {
    struct Start {
        const char* scene;
        const char* end;  // while most is in motion
    };
    for (const auto& [name, end] :
         {Start{"pile", "0.3"}, Start{"drum", "0.3"}, Start{"sphere_heap", "0.2"}}) {
        std::vector<double> shares;
        for (const char* rtol : {"1e-2", "1e-3", "1e-4"}) {
            Simulation simulation(shipped(name, {"stepping.rtol=" + std::string(rtol), "stepping.atol=1e-9",
                                                 "end_time=" + std::string(end)}));
            run(simulation);
            const EnergyLedger& energy = simulation.report().energy;
            shares.push_back(std::abs(energy.residual) / (energy.lost() + energy.kinetic));
        }
        CAPTURE(name, shares);
        CHECK(shares[0] < 0.2);
        CHECK(shares[1] < 0.3 * shares[0]);
        CHECK(shares[2] < 0.3 * shares[1]);
    }
}
