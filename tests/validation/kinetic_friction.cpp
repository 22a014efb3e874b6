// A block on a slope between its kinetic and its static angle of friction.

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

using Settings = std::vector<std::string>;

constexpr double gravity = 9.81;
constexpr double held = 0.6;
constexpr double kinetic = 0.4;

const Settings methods[] = {
    {"stepping.rtol=1e-5"},
    {R"(stepping={"method":"verlet","step":2e-5})", "materials.rock.youngs_modulus=1e7"},
    {R"(stepping={"method":"symplectic_euler","step":2e-5})", "materials.rock.youngs_modulus=1e7"}};

Vec3 gravity_on(double tangent) {
    return gravity * Vec3(tangent, 0, -1).normalized();
}

// A flat block on a floor, with a velocity. Its tangential spring is damped so that it rises to its load
// without going beyond.
SceneDescription block(const Settings& method, double speed) {
    SceneDescription scene = parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e9, "friction": 0.6,
                               "kinetic_friction": 0.4, "tangential_damping": 4}},
        "shapes": {"crate": {"box": [0.2, 0.1, 0.05]}, "floor": {"half_space": {"normal": [0, 0, 1]}}},
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "crate", "material": "rock", "position": [0, 0, 0.025]}],
        "end_time": 0.5})",
                                         "slope.json", method);
    scene.bodies[1].velocity.x() = speed;
    return scene;
}

void advance(Simulation& simulation, std::int64_t ticks) {
    for (std::int64_t i = 0; i < ticks; ++i) {
        const bool good = simulation.advance();
        INFO(simulation.world().step_report().message);
        REQUIRE(good);
    }
}

// Downhill [m/s²], of a block that comes to rest or glides on the level for 0.1 s before gravity turns, as
// slowly as not to shake it.
double acceleration(const Settings& method, double tangent, double speed) {
    Simulation simulation(block(method, speed));
    advance(simulation, 5);
    for (int i = 1; i <= 10; ++i) {
        const Vec3 turned = gravity_on(0.1 * i * tangent);
        simulation.world().setGravity(btVector3(turned.x(), turned.y(), turned.z()));
        advance(simulation, 1);
    }
    const double before = simulation.body_motion(1).velocity.x();
    advance(simulation, 10);
    return (simulation.body_motion(1).velocity.x() - before) / 0.2;
}

double sliding(double tangent) {
    return gravity * (tangent - kinetic) / std::hypot(1, tangent);
}

}  // namespace

TEST_CASE("Between the two angles a block at rest stays, and one that slides goes on", "[laws]") {
    for (const Settings& method : methods) {
        for (const double tangent : {0.45, 0.5, 0.58}) {
            CAPTURE(method[0], tangent);
            CHECK(std::abs(acceleration(method, tangent, 0)) < 1e-4 * gravity);
            CHECK(acceleration(method, tangent, 1) == Approx(sliding(tangent)).epsilon(1e-3));
        }
    }
}

TEST_CASE("Above the static angle a block breaks loose and slides with the kinetic friction", "[laws]") {
    for (const Settings& method : methods) {
        CAPTURE(method[0]);
        CHECK(acceleration(method, 0.65, 0) == Approx(sliding(0.65)).epsilon(1e-3));
        CHECK(acceleration(method, 0.65, 1) == Approx(sliding(0.65)).epsilon(1e-3));
    }
}

TEST_CASE(
    "A block that is thrown over level ground stops by its kinetic friction and is held by its static one",
    "[laws]") {
    for (const Settings& method : methods) {
        CAPTURE(method[0]);
        Simulation simulation(block(method, 1));
        advance(simulation, 25);
        const double way = 1 / (2 * kinetic * gravity);
        CHECK(simulation.body_motion(1).pose.position.x() == Approx(way).epsilon(1e-3));
        CHECK(simulation.body_motion(1).velocity.norm() < 1e-6);
        CHECK(simulation.world().contact_results()[0].law.state == ContactState::stick);
    }
}
