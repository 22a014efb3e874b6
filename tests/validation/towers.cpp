// Towers of cubes: stiffness does not set the price, weight does not make them creep, and they buckle where a
// column of such joints does.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

constexpr double gravity = 9.81;
const double length_of_edge = 2 * std::cbrt(3 / (4 * std::numbers::pi));  // Lc of two like cubes, Eq. (5.3)

// Cubes, each of its own density, that start where the law, Eq. (5.7), bears them.
struct Tower {
    double edge = 0.1;  // [m]
    double modulus = 1e10;
    std::vector<double> densities;  // [kg/m³], from below
    double end = 10;
    double push = 0;  // [m/s], of the uppermost

    [[nodiscard]] double weight_above(std::size_t face) const {
        double weight = 0;
        for (std::size_t k = face; k < densities.size(); ++k) {
            weight += densities[k] * std::pow(edge, 3) * gravity;
        }
        return weight;
    }
    // m g Lc/(Y A) for all that stands on the face.
    [[nodiscard]] double sinking(std::size_t face) const {
        return weight_above(face) * length_of_edge * edge / (modulus * edge * edge);
    }
};

std::string printed(const char* format, double a, double b = 0, double c = 0, double d = 0) {
    char text[300];
    std::snprintf(text, sizeof text, format, a, b, c, d);
    return text;
}

std::string scene_of(const Tower& tower) {
    std::string materials;
    std::string bodies = R"({"shape": "floor", "material": "m0", "motion": "fixed"})";
    double height = 0;
    for (std::size_t k = 0; k < tower.densities.size(); ++k) {
        const auto number = static_cast<double>(k);
        materials += k == 0 ? "" : ", ";
        materials += printed(R"("m%.0f": {"density": %.17g, "youngs_modulus": %.17g, "friction": 0.5})",
                             number, tower.densities[k], tower.modulus);
        height += tower.edge - tower.sinking(k);
        bodies += printed(R"(, {"shape": "cube", "material": "m%.0f", "position": [0, 0, %.17g])", number,
                          height - tower.edge / 2);
        bodies +=
            k + 1 == tower.densities.size() ? printed(R"(, "velocity": [%.17g, 0, 0]})", tower.push) : "}";
    }
    std::string text = R"({"materials": {)";
    text += materials;
    text += R"(}, "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}}, "cube": {"box": )";
    text += printed("[%.17g, %.17g, %.17g]", tower.edge, tower.edge, tower.edge);
    text += R"(}}, "bodies": [)";
    text += bodies;
    text += printed(R"(], "end_time": %.17g, "output": {"every": %.17g}})", tower.end, tower.end / 100);
    return text;
}

struct Stand {
    double drift = 0;    // [edges], the farthest that any cube went sideways
    double sinking = 0;  // the largest relative error of a face's, beyond 1e-9 edges
    double steps = 0;
    double mean_step = 0;  // [s]
};

Stand stand_of(const Tower& tower, const std::vector<std::string>& settings = {}) {
    Simulation simulation(parse_scene(scene_of(tower), "tower.json", settings));
    Stand stand;
    while (simulation.tick() < simulation.times().last()) {
        REQUIRE(simulation.advance());
        double below = 0;
        for (std::size_t k = 0; k < tower.densities.size(); ++k) {
            const Vec3 position = simulation.body_motion(k + 1).pose.position;
            stand.drift = std::max(stand.drift, std::hypot(position.x(), position.y()) / tower.edge);
            const double sunk = tower.edge + below - (position.z() + tower.edge / 2);
            const double error = std::abs(sunk - tower.sinking(k)) - 1e-9 * tower.edge;
            stand.sinking = std::max(stand.sinking, error / tower.sinking(k));
            below = position.z() + tower.edge / 2;
        }
    }
    stand.steps = static_cast<double>(simulation.report().steps.accepted);
    stand.mean_step = tower.end / stand.steps;
    return stand;
}

Tower uniform(std::size_t cubes, double edge, double modulus) {
    return {edge, modulus, std::vector<double>(cubes, 2600.0)};
}

}  // namespace

TEST_CASE("A tower of thirty cubes stands at any stiffness and size, for the same number of steps") {
    std::vector<double> steps;
    for (const double edge : {1e-3, 0.1, 1.0}) {
        for (const double modulus : {1e10, 1e11, 1e12, 1e13}) {
            CAPTURE(edge, modulus);
            const Stand stand = stand_of(uniform(30, edge, modulus));
            CHECK(stand.drift < 1e-6);
            CHECK(stand.sinking < 0.01);
            steps.push_back(stand.steps);
        }
    }
    CAPTURE(steps);
    const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
    CHECK(*most <= 2 * *least);
}

TEST_CASE("The resting tower's steps are a hundred times an explicit method's, with the same result") {
    const Tower tower = uniform(30, 0.1, 1e10);
    const Stand stand = stand_of(tower);
    // ω of the stiffest mode of a chain, twice a single contact's: an explicit step is below 2/ω.
    const double stiffness = tower.modulus * tower.edge * tower.edge / (length_of_edge * tower.edge);
    const double limit = 1 / std::sqrt(stiffness / (2600 * std::pow(tower.edge, 3)));
    CHECK(stand.mean_step > 100 * limit);
    CHECK(stand.sinking < 1e-3);
}

TEST_CASE("A tower stands whether the light cube is below the heavy one or above it, up to a million times") {
    for (const double ratio : {1e3, 1e6}) {
        for (const bool heavy_above : {true, false}) {
            CAPTURE(ratio, heavy_above);
            Tower tower{0.1, 1e11, {2.6, 2.6}, 10};
            tower.densities[heavy_above ? 1 : 0] *= ratio;
            const Stand stand = stand_of(tower);
            CHECK(stand.drift < 1e-6);
            CHECK(stand.sinking < 0.01);
        }
    }
}

// Joints with the rotational stiffness (Y/Lc) a⁴/12 under the weight of what is above: a column of n cubes
// buckles below Y = (n+½)³ a ρ g/0.526, within half a per cent for n ≥ 10.
TEST_CASE("A tower buckles under its own weight a fifth below the limit and stands a quarter above it") {
    const double limit = std::pow(10.5, 3) * 0.1 * 2600 * gravity / 0.526;
    for (const double share : {0.8, 1.25}) {
        CAPTURE(share);
        Tower tower = uniform(10, 0.1, share * limit);
        tower.push = 1e-3;
        const Stand stand = stand_of(tower);
        if (share < 1) {
            CHECK(stand.drift > 1);
        } else {
            CHECK(stand.drift < 0.1);
        }
    }
}
