#include <catch2/catch.hpp>

#include <scree/overlap/overlap.hpp>
#include <scree/scenes/simulation.hpp>

#include "small_scene.hpp"

using namespace scree;
using namespace scree::test;

namespace {

const std::string filled_scene = R"({
    "materials": {"rock": {"density": 2600, "youngs_modulus": 1e9, "friction": 0.5}},
    "shapes": {
        "floor": {"half_space": {"normal": [0, 0, 1]}},
        "stone": {"mesh": "stone_a.obj", "scale": 0.05},
        "crate": {"box": [0.04, 0.03, 0.02]},
        "ball": {"sphere": 0.01},
        "slab": {"box": [1, 1, 0.02]}
    },
    "bodies": [
        {"shape": "floor", "material": "rock", "motion": "fixed"},
        {"shape": "slab", "material": "rock", "motion": "fixed", "position": [0, 0, 0.1]}
    ],
    "fill": [
        {"shape": "stone", "material": "rock", "count": 40, "size": [0.8, 1.2], "seed": 7,
         "box": [[-0.1, -0.1, -0.1], [0.1, 0.1, 0.3]]},
        {"shape": "crate", "material": "rock", "count": 40, "seed": 7,
         "box": [[-0.1, -0.1, -0.1], [0.1, 0.1, 0.3]]},
        {"shape": "ball", "material": "rock", "count": 40,
         "box": [[-0.1, -0.1, -0.1], [0.1, 0.1, 0.3]]}
    ],
    "end_time": 0.1
})";

SceneDescription filled_with(const std::vector<std::string>& settings = {}) {
    return parse_scene(filled_scene, SCREE_SOURCE_DIR "/meshes/filled.json", settings);
}

bool mixed(const Shape& a, const Shape& b) {
    return (std::holds_alternative<Sphere>(a) && std::holds_alternative<ConvexPolyhedron>(b)) ||
           (std::holds_alternative<Sphere>(b) && std::holds_alternative<ConvexPolyhedron>(a));
}

bool same_pose(const Pose& a, const Pose& b) {
    return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

}  // namespace

TEST_CASE("No two filled bodies overlap, nor do they overlap what was there", "[scenes]") {
    const Simulation simulation(filled_with());
    OverlapWorkspace workspace;
    ContactGeometry geometry;
    REQUIRE(simulation.bodies().size() == 122);
    for (std::size_t i = 2; i < simulation.bodies().size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Shape& a = *simulation.bodies()[i].solid.shape;
            const Shape& b = *simulation.bodies()[j].solid.shape;
            if (!mixed(a, b)) {
                const bool both =
                    overlap(a, simulation.body_motion(i).pose, b, simulation.body_motion(j).pose,
                            Detail::force, false, workspace, geometry);
                CHECK((!both || geometry.depth < 1e-12));
            }
        }
    }
}

TEST_CASE("Filled bodies are wholly inside their box", "[scenes]") {
    const Simulation simulation(filled_with());
    for (std::size_t i = 2; i < simulation.bodies().size(); ++i) {
        const Bounds box = bounds(*simulation.bodies()[i].solid.shape, simulation.body_motion(i).pose);
        CHECK((box.low.array() >= Vec3(-0.1, -0.1, -1e-12).array() - 1e-12).all());
        CHECK((box.high.array() <= Vec3(0.1, 0.1, 0.3).array() + 1e-12).all());
    }
}

TEST_CASE("A seed gives the same fill again, another seed another one", "[scenes]") {
    const Simulation first(filled_with());
    const Simulation again(filled_with());
    const Simulation other(filled_with({"fill.0.seed=8"}));
    bool differs = false;
    for (std::size_t i = 0; i < first.bodies().size(); ++i) {
        CHECK(same_pose(first.file_motion(i).pose, again.file_motion(i).pose));
        differs = differs || !same_pose(first.file_motion(i).pose, other.file_motion(i).pose);
    }
    CHECK(differs);
}

TEST_CASE("Sizes spread over their range and scale the mass", "[scenes]") {
    const Simulation simulation(filled_with());
    double least = 2;
    double most = 0;
    double reference = 0;
    {
        const Simulation one_size(filled_with({"fill.0.size=[1,1]"}));
        reference = one_size.bodies()[2].solid.volume;
    }
    for (std::size_t i = 2; i < 42; ++i) {
        const Solid& solid = simulation.bodies()[i].solid;
        const double factor = std::cbrt(solid.volume / reference);
        least = std::min(least, factor);
        most = std::max(most, factor);
        CHECK(1 / simulation.bodies()[i].rigid->getInvMass() == Approx(2600 * solid.volume).epsilon(1e-14));
    }
    CHECK(least >= 0.8);
    CHECK(least < 0.85);
    CHECK(most <= 1.2);
    CHECK(most > 1.15);
}

TEST_CASE("Filled bodies are named by shape and number", "[scenes]") {
    const Simulation simulation(filled_with());
    CHECK(simulation.bodies()[0].name == "floor.0");
    CHECK(simulation.bodies()[2].name == "stone.0");
    CHECK(simulation.bodies()[41].name == "stone.39");
    CHECK(simulation.bodies()[42].name == "crate.0");
    CHECK(simulation.bodies()[121].name == "ball.39");
}

TEST_CASE("A fill that does not fit is refused with how many did", "[scenes]") {
    const auto refusal = [](const std::vector<std::string>& settings) {
        try {
            const Simulation simulation(filled_with(settings));
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(refusal({"fill.0.count=5000"}), Catch::Contains("filled.json: fill.0: found room for ") &&
                                                   Catch::Contains(" of 5000, expected a larger box"));
    CHECK_THAT(refusal({"fill.1.box=[[0,0,0],[0.01,1,1]]"}),
               Catch::Contains("fill.1: found room for 0 of 40"));
}
