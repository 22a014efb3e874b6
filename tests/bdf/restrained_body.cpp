#include <catch2/catch.hpp>

#include <cmath>

#include <tests/bdf/stepping_case.hpp>

using namespace scree;
using namespace scree::test;

namespace {

SteppingOptions tight(Method method) {
    SteppingOptions options;
    options.method = method;
    options.tolerances.relative = 1e-6;
    if (method != Method::bdf) {
        options.fixed_step = 1e-5;
    }
    return options;
}

// A brick that lies askew, with a spin [rad/s]; in free space.
struct Brick {
    SteppingCase scene;
    Restraint restraint;
    Body& body;

    explicit Brick(const Vec3& spin)
        : body((scene.add_box({0.1, 0.2, 0.4}, 1000, Vec3::Zero()), scene.system.bodies[0])) {
        body.restraint = &restraint;
        state().orientation = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
        state().angular_momentum = world_inertia(body, state().orientation) * spin;
    }
    BodyState& state() { return scene.system.states[0]; }
    double run(Method method) {
        REQUIRE(scene.run(0.1, tight(method), 0.01) != nullptr);
        return scene.account.ledger().residual;
    }
};

}  // namespace

TEST_CASE("A damped body loses its momenta exponentially, and the ledger knows where they went") {
    const Method method = GENERATE(Method::bdf, Method::symplectic_euler, Method::velocity_verlet);
    Brick brick(Vec3(0, 0, 0.5));
    brick.restraint.slowing = 5;
    brick.restraint.turning_down = 3;
    brick.state().momentum = Vec3(1, 2, 0);
    const Vec3 turning = brick.state().angular_momentum;
    const double residual = brick.run(method);
    INFO(static_cast<int>(method));
    CHECK((brick.state().momentum - std::exp(-0.5) * Vec3(1, 2, 0)).norm() < 1e-4);
    CHECK((brick.state().angular_momentum - std::exp(-0.3) * turning).norm() < 1e-4 * turning.norm());
    const EnergyLedger& ledger = brick.scene.account.ledger();
    CHECK(ledger.work_applied == Approx(0.5 / brick.body.mass * 5 * std::expm1(-1)).epsilon(0.05));
    CHECK(std::abs(residual) < 1e-3 * std::abs(ledger.work_applied));
}

TEST_CASE("A body that turns about one axis alone obeys that axis's moment of inertia") {
    const Method method = GENERATE(Method::bdf, Method::symplectic_euler, Method::velocity_verlet);
    Brick brick(Vec3::Zero());
    brick.restraint.around = Vec3(0, 0, 1);
    brick.body.torque = Vec3(3, 4, 0.5);
    // About z the tensor's zz stays what it is while the body turns about z.
    const double inertia = world_inertia(brick.body, brick.state().orientation)(2, 2);
    const double residual = brick.run(method);
    INFO(static_cast<int>(method));
    const Vec3 turning = spin(brick.body, brick.state());
    CHECK(turning.z() == Approx(0.5 * 0.1 / inertia).epsilon(1e-6));
    CHECK(turning.head<2>().norm() < 1e-12 * turning.z());
    // Verlet's forces and velocities are half a step apart, 10⁻⁴ of the time here.
    CHECK(std::abs(residual) < 2e-4 * brick.scene.account.ledger().kinetic);
}

TEST_CASE("A spin that is held stays, whatever acts, and the work of holding it is in the ledger") {
    const Method method = GENERATE(Method::bdf, Method::symplectic_euler, Method::velocity_verlet);
    Brick brick(Vec3(1, 0, -2));
    brick.restraint.around = Vec3(0, 1, 0);
    brick.body.torque = Vec3(3, 0.2, 0.5);
    const double residual = brick.run(method);
    const Vec3 turning = spin(brick.body, brick.state());
    CHECK(turning.x() == Approx(1).epsilon(1e-9));
    CHECK(turning.z() == Approx(-2).epsilon(1e-9));
    CHECK(std::abs(residual) < 2e-4 * brick.scene.account.ledger().kinetic);
}

TEST_CASE("A body that may not move along an axis does not, and its weight is held up from outside") {
    const Method method = GENERATE(Method::bdf, Method::symplectic_euler, Method::velocity_verlet);
    Brick brick(Vec3::Zero());
    brick.restraint.along = Vec3(1, 0.5, 0);
    brick.body.weight = Vec3(0, 0, -9.81 * brick.body.mass);
    brick.body.force = Vec3(2, 2, 0);
    const double residual = brick.run(method);
    INFO(static_cast<int>(method));
    CHECK(brick.state().position.z() == 0);
    CHECK(brick.state().momentum.x() == Approx(0.2));
    CHECK(brick.state().momentum.y() == Approx(0.1));
    // Verlet's forces and velocities are half a step apart, 10⁻⁴ of the time here.
    CHECK(std::abs(residual) < 2e-4 * brick.scene.account.ledger().kinetic);
}
