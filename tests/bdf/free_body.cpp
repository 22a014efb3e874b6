#include <catch2/catch.hpp>
#include <tests/bdf/stepping_case.hpp>
#include <tests/support/order.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// An asymmetric top, I = (1, 2, 3).
SteppingCase top() {
    SteppingCase scene;
    const int body = scene.add_box(Vec3::Ones(), 1, Vec3::Zero());
    scene.system.bodies[static_cast<std::size_t>(body)].inertia = Vec3(1, 2, 3);
    scene.system.states[0].angular_momentum = Vec3(0.3, 2, -0.4);
    scene.system.states[0].momentum = Vec3(1, -2, 0.5);
    return scene;
}

Quat orientation_after(double duration, const SteppingOptions& options) {
    SteppingCase scene = top();
    REQUIRE(scene.run(duration, options, 0.5) != nullptr);
    return scene.system.states[0].orientation;
}

SteppingOptions fixed(std::size_t order, double step) {
    SteppingOptions options;
    options.max_order = order;
    options.fixed_step = step;
    return options;
}

}  // namespace

TEST_CASE("A free body keeps momentum and angular momentum to rounding", "[bdf]") {
    SteppingCase scene = top();
    const BodyState start = scene.system.states[0];
    REQUIRE(scene.run(20, {}, 0.5) != nullptr);
    const BodyState& end = scene.system.states[0];
    CHECK((end.momentum - start.momentum).norm() < 1e-14);
    CHECK((end.angular_momentum - start.angular_momentum).norm() < 1e-14);
    // Straight on, to the rounding of some thousand additions.
    CHECK((end.position - 20 * start.momentum / scene.system.bodies[0].mass).norm() < 1e-10);
}

TEST_CASE("The orientation of a free asymmetric body converges with the order of the formula", "[bdf]") {
    SteppingOptions tight;
    tight.tolerances.relative = 1e-9;
    tight.tolerances.absolute = 1e-12;
    const Quat exact = orientation_after(2, tight);
    for (const std::size_t order : {1U, 2U}) {
        std::vector<double> errors;
        for (double step = 0.01; step > 0.001; step /= 2) {
            errors.push_back(orientation_after(2, fixed(order, step)).angularDistance(exact));
        }
        CAPTURE(order, errors);
        CHECK(observed_order(errors) == Approx(static_cast<double>(order)).margin(0.25));
    }
}

TEST_CASE("Explicit methods turn a free asymmetric body with second order", "[bdf]") {
    const Quat exact = orientation_after(2, fixed(5, 5e-4));
    for (const Method method : {Method::symplectic_euler, Method::velocity_verlet}) {
        std::vector<double> errors;
        for (double step = 0.01; step > 0.001; step /= 2) {
            SteppingOptions options = fixed(1, step);
            options.method = method;
            errors.push_back(orientation_after(2, options).angularDistance(exact));
        }
        CAPTURE(errors);
        CHECK(observed_order(errors) == Approx(2).margin(0.1));
    }
}

TEST_CASE("The error of a free top follows the tolerance", "[bdf]") {
    SteppingOptions options;
    options.tolerances.absolute = 1e-12;
    options.tolerances.relative = 1e-9;
    const Quat exact = orientation_after(2, options);
    std::vector<double> errors;
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
        options.tolerances.relative = tolerance;
        errors.push_back(orientation_after(2, options).angularDistance(exact));
        CAPTURE(tolerance);
        CHECK(errors.back() < 200 * tolerance);
    }
    // The error a step is the tolerance, the error a second then its power 2/3 at second order.
    CHECK(errors.back() < 2e-2 * errors.front());
}
