#include <cmath>

#include <catch2/catch.hpp>
#include <tests/bdf/stepping_case.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double modulus = 1e8;

PairMaterial material(double friction) {
    PairMaterial pair;
    pair.youngs_modulus = modulus;
    pair.friction = friction;
    return pair;
}

// A cube of 0.1 m and 2.6 kg over the plane z = 0.
SteppingCase cube(double gravity, double height, double friction) {
    SteppingCase scene;
    scene.gravity = gravity;
    scene.add_ground(HalfSpace{});
    scene.add_box(Vec3::Constant(0.1), 2600, Vec3(0, 0, 0.05 + height));
    scene.touch(0, 1, material(friction));
    return scene;
}

}  // namespace

TEST_CASE("A flat bounce returns the closed form's speed at any damping", "[bdf]") {
    // Restitution of a linear spring and damper cut off at zero force; zeta = gamma √A/(2 Lc), Eq. (5.7).
    const double zetas[] = {0.05, 0.2, 0.5, 0.8};
    const double restitution[] = {0.858758, 0.571740, 0.298436, 0.179783};
    for (int i = 0; i < 4; ++i) {
        SteppingCase scene = cube(0, 1e-6, 0);
        PairConstants& pair = scene.system.contacts[0].pair;
        const double stiffness = pair.elastic * 0.01;  // Y A/Lc
        pair.normal_damping = 2 * zetas[i] * std::sqrt(stiffness * 2.6) / 0.01;
        scene.system.states[1].momentum = Vec3(0, 0, -2.6);
        SteppingOptions options;
        options.tolerances.relative = 1e-7;
        options.tolerances.absolute = 1e-10;
        REQUIRE(scene.run(0.01, options, 0.01) != nullptr);
        CAPTURE(zetas[i]);
        CHECK(scene.system.states[1].momentum.z() / 2.6 == Approx(restitution[i]).margin(1e-5));
    }
}

TEST_CASE("A resting cube sinks as deep as the law says, in steps as long as the tick", "[bdf]") {
    SteppingCase scene = cube(9.81, 0, 0.5);
    const auto integrator = scene.run(4, {}, 0.02);
    REQUIRE(integrator != nullptr);
    const double depth = 2.6 * 9.81 / (scene.system.contacts[0].pair.elastic * 0.01);
    CHECK(0.05 - scene.system.states[1].position.z() == Approx(depth).epsilon(1e-6));
    CHECK(scene.system.states[1].momentum.norm() < 1e-12);
    CHECK(integrator->statistics().largest_step > 0.019);
    CHECK(integrator->statistics().accepted < 300);
}

TEST_CASE("The ledger's residual falls with the tolerance", "[bdf]") {
    std::vector<double> residuals;
    for (const double tolerance : {1e-3, 1e-5}) {
        SteppingCase scene = cube(9.81, 0.02, 0.5);
        scene.system.states[1].momentum = Vec3(1, 0.3, 0);
        SteppingOptions options;
        options.tolerances.relative = tolerance;
        const auto integrator = scene.run(0.3, options, 0.02);
        REQUIRE(integrator != nullptr);
        const EnergyLedger& ledger = scene.account.ledger();
        residuals.push_back(std::abs(ledger.residual));
        CHECK(ledger.lost_friction > 0);
        CHECK(ledger.lost_normal_damping > 0);
        CHECK(scene.account.momentum_residual().norm() < 1e-3);
    }
    // Of 0.5 J that the fall and the slide have.
    CHECK(residuals[0] < 0.05);
    CHECK(residuals[1] < 0.1 * residuals[0]);
}

TEST_CASE("Explicit methods come to the same sliding block at steps that they can bear", "[bdf]") {
    for (const Method method : {Method::symplectic_euler, Method::velocity_verlet}) {
        SteppingCase scene = cube(9.81, 0, 0.5);
        scene.system.bodies[1].force = Vec3(0.8 * 2.6 * 9.81, 0, 0);
        SteppingOptions options;
        options.method = method;
        options.fixed_step = 2e-5;
        REQUIRE(scene.run(0.1, options, 0.02) != nullptr);
        // The start, unstretched, gains some speed; steady slip adds 0.3 g a second.
        CHECK(scene.system.states[1].momentum.x() / 2.6 == Approx(0.3 * 9.81 * 0.1).epsilon(0.03));
    }
}

TEST_CASE("Nothing passes a wall in a step that is fixed", "[bdf]") {
    for (const double speed : {100.0, 1e4}) {
        SteppingCase scene;
        scene.add_ground(make_box(Vec3(1, 1, 0.01)));
        scene.add_box(Vec3::Constant(0.1), 2600, Vec3(0, 0, 1));
        PairMaterial pair = material(0.5);
        pair.youngs_modulus = 1e13;
        scene.touch(0, 1, pair);
        scene.system.states[1].momentum = Vec3(0, 0, -2.6 * speed);
        SteppingOptions options;
        options.fixed_step = 0.1 / speed;
        scene.run(3 / speed, options, 3 / speed);
        CAPTURE(speed);
        CHECK(scene.system.states[1].position.z() > 0);
        CHECK(scene.system.states[1].momentum.z() > 0);
    }
}

TEST_CASE("A step that cannot be solved is never accepted", "[bdf]") {
    // The force is not a number anywhere: no step can converge, and the state stays as it was.
    SteppingCase scene = cube(9.81, 0, 0.5);
    scene.system.bodies[1].weight.x() = std::numeric_limits<double>::quiet_NaN();
    const BodyState start = scene.system.states[1];
    CHECK(scene.run(0.1, {}, 0.02) == nullptr);
    CHECK(scene.system.states[1].position == start.position);
    CHECK(scene.system.states[1].momentum == start.momentum);
}
