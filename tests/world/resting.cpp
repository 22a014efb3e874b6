#include <catch2/catch.hpp>

#include <cmath>

#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Lc of a cube on a fixed floor: the sphere of the cube's volume touching its like.
double cube_length(double edge) {
    return 2 * sphere_radius(edge * edge * edge);
}

}  // namespace

TEST_CASE("a box rests on a plane as deep as the law says") {
    const double edge = GENERATE(0.1, 1e-4);
    const double youngs_modulus = GENERATE(1e8, 1e11);
    BulletScene scene;
    btRigidBody& floor = scene.add_floor();
    const double mass = 2600 * edge * edge * edge;
    const double depth = mass * 9.81 * cube_length(edge) / (youngs_modulus * edge * edge);
    btRigidBody& box = scene.add(mass, scene.box(Vec3::Constant(edge)), Vec3(0, 0, edge / 2));
    scene.world->set_material(floor, rock(youngs_modulus));
    scene.world->set_material(box, rock(youngs_modulus));
    for (int i = 0; i < 100; ++i) {
        scene.world->stepSimulation(0.01, 1, 0.01);
    }
    const StepReport& report = scene.world->step_report();
    INFO(report.message << " steps " << report.steps.accepted);
    REQUIRE_FALSE(report.failed);
    CHECK(report.time == 1);
    CHECK(report.contacts == 1);
    const double sunk = edge / 2 - position_of(box).z();
    CHECK(std::abs(sunk - depth) < 1e-6 * depth + 1e-15 * edge);
    CHECK(box.getLinearVelocity().length() < 1e-8);
    CHECK(std::abs(scene.world->contact_results()[0].depth - depth) < 1e-6 * depth + 1e-15 * edge);
}
