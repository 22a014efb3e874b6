// Bodies that hold on to one another, against closed forms.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

constexpr double gravity = 9.81;
constexpr double radius = 0.05;
constexpr double modulus = 1e8;

double ball_mass() {
    return 2600 * 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
}

// A ball and a half-space with a normal; cohesion in N.
SceneDescription ball_at(const std::string& normal, double cohesion) {
    SceneDescription scene = parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e8, "friction": 0.5}},
        "shapes": {"ball": {"sphere": 0.05}, "tile": {"box": [0.02, 0.1, 0.1]},
                   "wall": {"half_space": {"normal": )" +
                                             normal + R"(}}},
        "bodies": [{"shape": "wall", "material": "rock", "motion": "fixed"},
                   {"shape": "ball", "material": "rock"}],
        "stepping": {"rtol": 1e-6, "atol": 1e-9},
        "end_time": 0.2})",
                                         "cohesion.json");
    scene.materials.at("rock").cohesion = cohesion;
    return scene;
}

// The depth [m] to which a force presses the ball into a half-space: V = π δ² (r − δ/3).
double depth_under(double force) {
    const double volume = force * 2 * radius / modulus;
    double depth = std::sqrt(volume / (std::numbers::pi * radius));
    for (int i = 0; i < 20; ++i) {
        depth = std::sqrt(volume / (std::numbers::pi * (radius - depth / 3)));
    }
    return depth;
}

void advance(Simulation& simulation, std::int64_t ticks) {
    for (std::int64_t i = 0; i < ticks; ++i) {
        const bool good = simulation.advance();
        INFO(simulation.world().step_report().message);
        REQUIRE(good);
    }
}

}  // namespace

TEST_CASE("A ball hangs from the ceiling by a cohesion above its weight, as deep as what is left presses it",
          "[laws]") {
    const double weight = ball_mass() * gravity;
    for (const double share : {1.02, 1.5, 4.0}) {
        CAPTURE(share);
        SceneDescription scene = ball_at("[0, 0, -1]", share * weight);
        const double depth = depth_under((share - 1) * weight);
        scene.bodies[1].position.z() = -radius + depth;
        Simulation simulation(scene);
        advance(simulation, 10);
        CHECK(simulation.body_motion(1).velocity.norm() < 1e-7);
        CHECK(simulation.body_motion(1).pose.position.z() + radius == Approx(depth).epsilon(1e-3));
        CHECK(simulation.world().step_report().energy.cohesive ==
              Approx(-share * weight * depth).epsilon(2e-3));
    }
}

TEST_CASE("A ball hangs by its cohesion under explicit methods, too", "[laws]") {
    for (const SteppingMethod method : {SteppingMethod::verlet, SteppingMethod::symplectic_euler}) {
        const double weight = ball_mass() * gravity;
        const double depth = depth_under(0.5 * weight);
        SceneDescription scene = ball_at("[0, 0, -1]", 1.5 * weight);
        scene.stepping.method = method;
        scene.stepping.step = 2e-5;
        scene.bodies[1].position.z() = -radius + 0.9 * depth;
        Simulation simulation(scene);
        for (int tick = 0; tick < 10; ++tick) {
            advance(simulation, 1);
            CHECK(simulation.body_motion(1).pose.position.z() + radius == Approx(depth).epsilon(0.15));
        }
    }
}

TEST_CASE("A cohesion below its weight does not hold a ball", "[laws]") {
    SceneDescription scene = ball_at("[0, 0, -1]", 0.98 * ball_mass() * gravity);
    scene.bodies[1].position.z() = -radius + 1e-6;
    Simulation simulation(scene);
    advance(simulation, 10);
    CHECK(simulation.body_motion(1).velocity.z() < -0.5 * gravity * 0.2);
    CHECK(simulation.world().step_report().energy.cohesive == 0);
    CHECK(std::abs(simulation.world().step_report().energy.residual) < 1e-6);
}

TEST_CASE("Without damping a ball bounces off a cohesive floor as fast as it came, with damping it may stick",
          "[laws]") {
    const auto bounce = [](double damping, double speed) {
        SceneDescription scene = ball_at("[0, 0, 1]", 20);
        scene.gravity.setZero();
        scene.materials.at("rock").normal_damping = damping;
        scene.bodies[1].position.z() = radius + 1e-3;
        scene.bodies[1].velocity.z() = -speed;
        Simulation simulation(scene);
        advance(simulation, 10);
        const EnergyLedger& energy = simulation.world().step_report().energy;
        const double well = 20 * depth_under(20);  // [J], which it falls into and climbs out of
        const double start = 0.5 * ball_mass() * speed * speed + well;
        CHECK(std::abs(energy.residual) < 1e-3 * start);
        CHECK(std::abs(energy.lost_cohesion) < 1e-3 * start);
        const bool apart = simulation.world().step_report().contacts == 0;
        return apart ? simulation.body_motion(1).velocity.z() / speed : 0;
    };
    CHECK(bounce(0, 0.1) == Approx(1).epsilon(1e-3));
    CHECK(bounce(0, 1) == Approx(1).epsilon(1e-3));
    CHECK(bounce(0.5, 1) > 0.5);
    CHECK(bounce(0.5, 0.02) == 0);  // it stays
}

TEST_CASE("A tile sticks to a vertical wall by μ times its cohesion, and slides with g − μ F/m", "[laws]") {
    const double mass = 2600 * 0.02 * 0.1 * 0.1;
    const auto speed_after = [&](double share) {
        SceneDescription scene = ball_at("[1, 0, 0]", share * mass * gravity / 0.5);
        scene.bodies[1].shape = "tile";
        scene.bodies[1].position.x() = 0.01 - 1e-7;
        scene.end_time = 0.4;
        Simulation simulation(scene);
        advance(simulation, 10);
        const double before = simulation.body_motion(1).velocity.z();
        advance(simulation, 10);
        return (simulation.body_motion(1).velocity.z() - before) / 0.2;
    };
    CHECK(std::abs(speed_after(1.1)) < 1e-6 * gravity);
    CHECK(speed_after(0.9) == Approx(-0.1 * gravity).epsilon(2e-2));
    CHECK(speed_after(0.5) == Approx(-0.5 * gravity).epsilon(2e-2));
}
