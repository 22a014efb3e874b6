#include <limits>

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

TEST_CASE("By Bullet's manifolds a cube slides v²/(2 μ g) and stays flat, however long the tick",
          "[scenes]") {
    for (const char* every : {"output.every=0.01", "output.every=0.1", "output.every=0.5"}) {
        Simulation simulation(small_scene_with(
            {"law.normal=manifold", "end_time=0.5", every, "bodies.1.velocity=[0.8,0.6,0]"}));
        while (simulation.time() < 0.5) {
            REQUIRE(simulation.advance());
        }
        const Pose& pose = simulation.body_motion(1).pose;
        const double way = 1 / (2 * 0.5 * 9.81);
        CAPTURE(every);
        CHECK((pose.position - Vec3(0.8 * way, 0.6 * way, 0.05)).norm() < 0.005 * way);
        CHECK((pose.orientation * Vec3::UnitZ() - Vec3::UnitZ()).norm() < 1e-5);
    }
}

TEST_CASE("By Bullet's manifolds nothing that tumbles is thrown up by what it sinks in between two ticks",
          "[scenes]") {
    for (const char* shape : {"hexagonal_prism", "icosahedron", "cube"}) {
        Simulation simulation(small_scene_with(
            {"law.normal=manifold", "end_time=1", "output.every=0.05", "gravity=[5.63,0,-8.04]",
             std::string("shapes.crate={\"mesh\":\"") + SCREE_SOURCE_DIR + "/meshes/" + shape +
                 ".obj\",\"scale\":0.2}",
             "shapes.floor={\"box\":[8,8,0.2]}", "bodies.0.position=[0,0,-0.1]",
             "bodies.1.position=[-0.5,0,0.3]"}));
        double least = std::numeric_limits<double>::infinity();
        double most_gain = 0;
        while (simulation.time() < 1) {
            REQUIRE(simulation.advance());
            const double held = simulation.world().step_report().energy.held();
            most_gain = std::max(most_gain, held - least);
            least = std::min(least, held);
        }
        CAPTURE(shape);
        CHECK(most_gain < 0.01);  // of 50 J and more in motion
    }
}

TEST_CASE("A scene that nobody watches has no manifolds", "[scenes]") {
    Simulation simulation(small_scene_with({}));
    REQUIRE(simulation.advance());
    CHECK(simulation.world().step_report().contacts > 0);
    CHECK(simulation.world().step_report().manifold_pairs == 0);
    CHECK(simulation.world().getDispatcher()->getNumManifolds() == 0);
}
