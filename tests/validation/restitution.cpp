// Impacts of whole bodies with a restitution that was asked for: by a damping whose ratio does not depend on
// the patch, on faces, edges, corners and balls alike.

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>
#include <scree/world/automatic_material.hpp>

using namespace scree;

namespace {

// A body that flies down on a floor without gravity, and does not touch it yet.
SceneDescription falling(const std::string& shape, double ratio, double speed) {
    SceneDescription scene = parse_scene(R"({
        "gravity": [0, 0, 0],
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e9, "friction": 0}},
        "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}}},
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "body", "material": "rock"}],
        "law": {"normal_damping": "patch"},
        "stepping": {"rtol": 1e-6, "atol": 1e-9},
        "end_time": 1})",
                                         "falling.json", {"shapes.body=" + shape});
    scene.materials.at("rock").normal_damping = 2 * ratio;
    scene.bodies[1].velocity = {0, 0, -speed};
    scene.output.every = 5e-3;
    scene.end_time = 0.2;
    return scene;
}

// Above the floor by the distance that it flies in 5 ms, `lowest` [m] being its lowest point at the origin.
double measured_restitution(SceneDescription scene, const Quat& turn, double lowest) {
    const double speed = -scene.bodies[1].velocity.z();
    scene.bodies[1].orientation = turn;
    scene.bodies[1].position.z() = lowest + 5e-3 * speed;
    Simulation simulation(scene);
    while (simulation.tick() < simulation.times().last()) {
        REQUIRE(simulation.advance());
    }
    REQUIRE(simulation.world().step_report().contacts == 0);
    CHECK(simulation.body_motion(1).angular_velocity.norm() < 1e-3 * speed);
    return simulation.body_motion(1).velocity.z() / speed;
}

}  // namespace

TEST_CASE("With damping by the patch a cube bounces as prescribed, on its face, its edge and its corner",
          "[laws]") {
    const std::string cube = R"({"box": [0.1, 0.1, 0.1]})";
    const Quat edge(Eigen::AngleAxisd(std::atan(1.0), Vec3::UnitY()));
    const Quat corner = Quat::FromTwoVectors(Vec3(1, 1, 1), -Vec3::UnitZ());
    for (const double ratio : {0.05, 0.3}) {
        for (const double speed : {0.1, 1.0}) {
            CAPTURE(ratio, speed);
            const SceneDescription scene = falling(cube, ratio, speed);
            CHECK(measured_restitution(scene, Quat::Identity(), 0.05) ==
                  Approx(restitution(ratio)).margin(2e-3));
            CHECK(measured_restitution(scene, edge, 0.05 * std::sqrt(2.0)) ==
                  Approx(restitution(ratio * std::sqrt(4.0 / 3))).margin(2e-3));
            CHECK(measured_restitution(scene, corner, 0.05 * std::sqrt(3.0)) ==
                  Approx(restitution(ratio * std::sqrt(1.5))).margin(2e-3));
        }
    }
}

TEST_CASE("With damping by the patch a ball bounces with the restitution of ζ √(4/3)", "[laws]") {
    for (const double ratio : {0.05, 0.3}) {
        const SceneDescription scene = falling(R"({"sphere": 0.05})", ratio, 0.1);
        CHECK(measured_restitution(scene, Quat::Identity(), 0.05) ==
              Approx(restitution(ratio * std::sqrt(4.0 / 3))).margin(2e-3));
    }
}
