// A long rod that is touched at its end: what the reduced masses of the tangential damping do.

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
constexpr double damping = 0.2;  // γt
constexpr double height = 1;     // [m]
constexpr double width = 0.01;

// A rod of 0.26 kg that stands on its end, pushed there so that nothing but the spring holds it: for as long
// as it swings its fall is not felt.
SceneDescription standing_rod(const std::string& reduced_mass, double period) {
    const double reach = 2 * std::cbrt(3 / (4 * std::numbers::pi) * width * width * height);  // Lc [m]
    const double sunk = 2600 * height * gravity * reach / 1e8;
    const double speed = 1e-6;  // [m/s], of the end
    // A push J at the end: J/m of the middle and 3 J/m of the end about it.
    const double middle = speed / 4;
    const double turning = 1.5 * speed / height;
    SceneDescription scene = parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e8, "friction": 0.5}},
        "shapes": {"rod": {"box": [0.01, 0.01, 1]}, "floor": {"half_space": {"normal": [0, 0, 1]}}},
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "rod", "material": "rock"}],
        "end_time": 1})",
                                         "rod.json", {"law.reduced_mass=" + reduced_mass});
    scene.materials.at("rock").tangential_damping = damping;
    scene.bodies[1].position = {0, 0, height / 2 - sunk};
    scene.bodies[1].velocity = {middle, 0, 0};
    scene.bodies[1].angular_velocity = {0, -turning, 0};
    scene.stepping.step = period / 1000;
    scene.output.every = period / 1000;
    scene.end_time = 4 * period;
    return scene;
}

// ζ and the period of the spring's force, from its extremes.
struct Swing {
    double ratio = 0;
    double period = 0;
};

Swing swing_of(Simulation& simulation) {
    std::vector<double> extremes, times;
    double last[2] = {0, 0};
    while (simulation.tick() < simulation.times().last()) {
        REQUIRE(simulation.advance());
        const double force = simulation.world().contact_results()[0].law.trial.force.x();
        if ((last[1] - last[0]) * (force - last[1]) < 0) {
            extremes.push_back(std::abs(last[1]));
            times.push_back(simulation.time());
        }
        last[0] = last[1];
        last[1] = force;
    }
    REQUIRE(extremes.size() >= 5);
    const double decrement = std::log(extremes[0] / extremes[4]) / 4;  // over half a period
    return {decrement / std::hypot(std::numbers::pi, decrement), (times[4] - times[0]) / 2};
}

}  // namespace

TEST_CASE("At the end of a rod ζ = (γt/2) √(M/M_exact): exact masses give γt/2, points twice that",
          "[laws]") {
    const double mass = 2600 * width * width * height;
    const double radius = std::cbrt(3 / (4 * std::numbers::pi) * width * width * height);
    const double inertia = mass * (height * height + width * width) / 12;
    const double about_axis = mass * width * width / 6;
    const double yields = 1 / (1 / mass + height * height / 4 / inertia);  // M_exact: a quarter of the mass
    const double round = 1 / (1 / mass + radius * radius / ((2 * inertia + about_axis) / 3));  // Eq. (5.27)
    const double stiffness = 2.0 / 7 * 1e8 * 2 * radius;                                       // Yt Lc
    const double free_period = 2 * std::numbers::pi * std::sqrt(yields / stiffness);
    const std::pair<const char*, double> masses[] = {{"point", mass}, {"round", round}, {"exact", yields}};
    for (const auto& [kind, damped] : masses) {
        CAPTURE(kind);
        const double ratio = damping / 2 * std::sqrt(damped / yields);
        Simulation simulation(standing_rod(kind, free_period));
        const Swing swing = swing_of(simulation);
        CHECK(swing.ratio == Approx(ratio).epsilon(0.01));
        CHECK(swing.period * std::sqrt(1 - ratio * ratio) == Approx(free_period).epsilon(0.01));
    }
    CHECK(yields == Approx(mass / 4).epsilon(1e-3));
}
