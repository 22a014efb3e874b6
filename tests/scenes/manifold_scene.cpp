#include <catch2/catch.hpp>

#include <scree/mesh/mass_properties.hpp>
#include <scree/scenes/features.hpp>
#include <scree/scenes/simulation.hpp>

#include "small_scene.hpp"

using namespace scree;
using namespace scree::test;

TEST_CASE("A scene runs with Bullet's manifolds in place of the overlap", "[scenes]") {
    const SceneDescription scene = small_scene_with({"law.normal=manifold", "end_time=1"});
    CHECK(scene_features(scene).uses("bullet_manifolds"));
    Simulation simulation(scene);
    while (simulation.time() < 1) {
        REQUIRE(simulation.advance());
    }
    // The block and the ball lie on the ground, sunk in by m g/(Y Lc).
    const double block = 2 * sphere_radius(1e-3);
    const double sunk = 2600 * 1e-3 * 9.81 / (1e9 * block);
    CHECK(0.05 - simulation.body_motion(1).pose.position.z() == Approx(sunk).epsilon(0.2));
    CHECK(0.05 - simulation.body_motion(2).pose.position.z() < 1e-6);
    CHECK(simulation.body_motion(1).velocity.norm() < 1e-3);
    CHECK(simulation.world().step_report().contacts == 2);
}

TEST_CASE("A scene that nobody watches has no manifolds", "[scenes]") {
    Simulation simulation(small_scene_with({}));
    REQUIRE(simulation.advance());
    CHECK(simulation.world().step_report().contacts > 0);
    CHECK(simulation.world().step_report().manifold_pairs == 0);
    CHECK(simulation.world().getDispatcher()->getNumManifolds() == 0);
}
