#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/scenes/features.hpp>
#include <scree/scenes/simulation.hpp>
#include <scree/world/automatic_material.hpp>

#include <tests/scenes/small_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double gravity = 9.81;

/// The small scene by Bullet's own solver.
Simulation simulation_of(std::vector<std::string> settings) {
    settings.emplace_back("stepping.method=bullet");
    return Simulation(small_scene_with(settings));
}

void run(Simulation& simulation) {
    while (simulation.tick() < simulation.times().last()) {
        REQUIRE(simulation.advance());
    }
}

const std::string mesh_crate =
    "shapes.crate={\"mesh\":\"" SCREE_SOURCE_DIR "/meshes/cube.obj\",\"scale\":0.1}";

}  // namespace

TEST_CASE("Bullet's steps divide the time between outputs and end on each", "[scenes]") {
    Simulation simulation = simulation_of({"output.every=0.03"});
    for (const double time : {0.03, 0.06, 3 * 0.03, 0.1}) {
        REQUIRE(simulation.advance());
        CHECK(simulation.time() == time);
        CHECK(simulation.report().time == time);
    }
    // 1/240 s goes into 0.03 s seven times and a bit, into 0.01 s twice and a bit.
    CHECK(simulation.report().steps.accepted == 3 * 8 + 3);
    CHECK(simulation.report().steps.largest_step == Approx(0.03 / 8));
    CHECK(simulation.report().steps.smallest_step == Approx(0.01 / 3));

    Simulation fine = simulation_of({"stepping.step=0.001", "stepping.iterations=50"});
    run(fine);
    CHECK(fine.report().steps.accepted == 100);
}

TEST_CASE("By Bullet's solver what lies on the floor stays there, boxes and meshes without a gap",
          "[scenes]") {
    const bool mesh = GENERATE(false, true);
    Simulation simulation = mesh ? simulation_of({mesh_crate, "end_time=1"}) : simulation_of({"end_time=1"});
    run(simulation);
    CHECK(simulation.file_motion(1).pose.position.z() == Approx(0.05).epsilon(0.01));
    CHECK(simulation.file_motion(1).velocity.norm() < 0.01);
    CHECK(simulation.file_motion(0).pose.position == Vec3::Zero());
    CHECK(simulation.contacts().size() == 2);
    CHECK(simulation.contacts()[0].a.body == 0);
    CHECK(simulation.contacts()[0].b.body == 1);
    const ContactResult& contact = simulation.contact_results()[0];
    CHECK(contact.law.normal_force == Approx(2.6 * gravity).epsilon(0.05));
    CHECK(contact.law.force.z() == Approx(-2.6 * gravity).epsilon(0.05));  // on the floor
    CHECK(contact.normal.z() == Approx(-1));
}

TEST_CASE("Bullet's solver uses the pair's friction, not a product of the materials'", "[scenes]") {
    Simulation simulation = simulation_of({"materials.rock.friction=0.9",
                                           "pairs=[{\"materials\":[\"rock\",\"rock\"],\"friction\":0.3}]",
                                           "bodies.1.velocity=[1,0,0]", "stepping.step=0.001"});
    run(simulation);
    const double lost = 1 - simulation.file_motion(1).velocity.x();
    CHECK(lost == Approx(0.3 * gravity * 0.1).epsilon(0.05));
    Simulation smooth = simulation_of({"law.friction=none", "bodies.1.velocity=[1,0,0]"});
    run(smooth);
    CHECK(smooth.file_motion(1).velocity.x() == Approx(1).epsilon(1e-6));
}

TEST_CASE("Bullet's solver takes its restitution from the pair's damping", "[scenes]") {
    // ζ = γn/2 at a face of area Lc², its restitution by the closed form. The ball arrives at the floor at
    // the end of a step of 1/250 s, 0.084 m farther down, so that nothing has to be corrected.
    Simulation simulation = simulation_of({"materials.rock.normal_damping=0.2", "gravity=[0,0,0]",
                                           "bodies.2.position=[1,0,0.134]", "bodies.2.velocity=[0,0,-1]"});
    run(simulation);
    CHECK(simulation.file_motion(2).velocity.z() == Approx(restitution(0.1)).epsilon(1e-3));
}

TEST_CASE("Prescribed bodies are kinematic ones for Bullet's solver, exactly where their motion leads",
          "[scenes]") {
    // A wall pushes the block along.
    Simulation simulation = simulation_of(
        {"shapes.wall={\"box\":[0.1,1,1]}",
         "bodies.2={\"name\":\"wall\",\"shape\":\"wall\",\"material\":\"rock\",\"position\":[-0.15,0,0.5],"
         "\"motion\":{\"velocity\":[0.5,0,0]}}",
         "end_time=0.5"});
    run(simulation);
    CHECK(simulation.file_motion(2).pose.position == Vec3(-0.15 + 0.5 * 0.5, 0, 0.5));
    CHECK(simulation.file_motion(2).velocity == Vec3(0.5, 0, 0));
    CHECK(simulation.file_motion(1).pose.position.x() == Approx(0.2).epsilon(0.02));
    CHECK(simulation.file_motion(1).velocity.x() == Approx(0.5).epsilon(0.1));
}

TEST_CASE("A conveyor drives for Bullet's solver too, by the friction of the pair", "[scenes]") {
    const std::string belt =
        "bodies.0={\"name\":\"belt\",\"shape\":\"floor\",\"material\":\"rock\","
        "\"motion\":{\"surface_velocity\":[0.3,0.4,5]}}";
    Simulation early = simulation_of({belt, "stepping.step=0.001", "end_time=0.05"});
    run(early);
    const Vec3 speeding = 0.5 * gravity * 0.05 * Vec3(0.6, 0.8, 0);
    CHECK((early.file_motion(1).velocity - speeding).norm() < 0.05 * speeding.norm());
    Simulation late = simulation_of({belt, "stepping.step=0.001", "end_time=0.5"});
    run(late);
    CHECK((late.file_motion(1).velocity - Vec3(0.3, 0.4, 0)).norm() < 0.01);
    CHECK(late.file_motion(0).pose.position == Vec3::Zero());
}

TEST_CASE("Bullet's solver gives the same numbers again", "[scenes]") {
    const std::vector<std::string> settings = {mesh_crate,
                                               "fill=[{\"shape\":\"crate\",\"material\":\"rock\",\"count\":"
                                               "30,\"box\":[[-0.3,-0.3,0.2],[0.3,0.3,1]]}]",
                                               "end_time=0.5"};
    Simulation one = simulation_of(settings);
    Simulation two = simulation_of(settings);
    run(one);
    run(two);
    for (std::size_t b = 0; b < one.bodies().size(); ++b) {
        CHECK(one.file_motion(b).pose.position == two.file_motion(b).pose.position);
        CHECK(one.file_motion(b).velocity == two.file_motion(b).velocity);
    }
    CHECK(one.contacts().size() == two.contacts().size());
}

TEST_CASE("A body that tumbles by Bullet's solver keeps the sign of its quaternion", "[scenes]") {
    Simulation simulation = simulation_of(
        {"gravity=[0,0,0]", "bodies.1.position=[0,0,1]", "bodies.1.angular_velocity=[0,0,10]", "end_time=2"});
    Quat last = simulation.file_motion(1).pose.orientation;
    CHECK(last.coeffs() == Quat::Identity().coeffs());
    while (simulation.tick() < simulation.times().last()) {
        REQUIRE(simulation.advance());
        const Quat now = simulation.file_motion(1).pose.orientation;
        CHECK(now.dot(last) > 0.9);
        last = now;
    }
}

TEST_CASE("What Bullet's solver has no notion of is left out, and its world is none of scree's", "[scenes]") {
    const SceneDescription scene = small_scene_with({"stepping.method=bullet"});
    const Features features = scene_features(scene);
    CHECK(features.uses("bullet_solver"));
    CHECK(features.uses("friction"));
    for (const char* name : {"torsion", "tangential_damping", "co_rotation", "elasticity", "newton",
                             "error_control", "energy_ledger"}) {
        CHECK_FALSE(features.uses(name));
    }
    Simulation simulation(scene);
    CHECK_THROWS_AS(simulation.world(), std::logic_error);
    run(simulation);
    const EnergyLedger& energy = simulation.report().energy;
    CHECK(energy.kinetic >= 0);
    CHECK(energy.gravity > 0);
    CHECK(energy.residual == 0);
}
