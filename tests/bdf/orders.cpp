#include <cmath>

#include <catch2/catch.hpp>
#include <tests/bdf/known_motions.hpp>
#include <tests/support/order.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double duration = 0.08;  // [s]

// Formulas of a given order need as much past. It comes from steps so small that their own low order does not
// matter, which grow slowly enough for the formulas to stay stable.
BodyState state_after(SteppingCase scene, std::size_t order, int steps) {
    constexpr double first = 1e-4;  // of a step
    constexpr double growth = 1.1;
    SteppingOptions options;
    options.tolerances.gravity = scene.gravity;
    options.tolerances.relative = 1e-9;  // to which the equations are solved, too
    options.tolerances.absolute = 1e-12;
    options.max_order = order;
    options.fixed_step = 1;
    const auto integrator = make_integrator(scene.system, scene.forces, options);
    integrator->restart(0);
    const double whole = duration / steps;
    double step = first * whole;
    while (integrator->time() < duration) {
        step = std::min(growth * step, whole);
        const double left = duration - integrator->time();
        const double next =
            step < left ? integrator->time() + left / std::ceil(left / step - 1e-6) : duration;
        REQUIRE(integrator->step(next) == StepOutcome::accepted);
    }
    return scene.system.states.back();
}

// The slope of the errors' logarithms over three halvings of the step.
double order_found(SteppingCase (*scene)(), std::size_t order) {
    const BodyState exact = state_after(scene(), highest_order, 1600);
    std::vector<double> errors;
    for (int steps = order > 3 ? 50 : 100; errors.size() < 3; steps *= 2) {
        errors.push_back(distance(state_after(scene(), order, steps), exact));
    }
    return observed_order(errors);
}

}  // namespace

TEST_CASE("Formulas of order 1 to 5 have that order on a free body and in contact, sticking or not",
          "[bdf]") {
    int number = 0;
    for (const auto scene : {top, floating_cube, sticking_cube}) {
        for (std::size_t order = 1; order <= highest_order; ++order) {
            CAPTURE(number, order);
            CHECK(order_found(scene, order) == Approx(static_cast<double>(order)).margin(0.3));
        }
        ++number;
    }
}

TEST_CASE("Eq. (5.15): friction has the order of the formula on a contact whose normal turns", "[bdf]") {
    for (const std::size_t order : {1U, 2U, 3U}) {
        CAPTURE(order);
        CHECK(order_found(turned_cube, order) == Approx(static_cast<double>(order)).margin(0.3));
    }
}

TEST_CASE("Eq. (5.7): a floating cube heaves as the damped oscillator does", "[bdf]") {
    SteppingCase scene = floating_cube();
    const double start = scene.system.states[1].position.z();
    const PairConstants& pair = scene.system.contacts[0].pair;
    const double omega = std::sqrt(pair.elastic * edge * edge / mass);
    const double decay = pair.normal_damping * edge * edge / (2 * mass);
    const double swing = std::sqrt(omega * omega - decay * decay);
    const double heave = 0.05 / swing * std::exp(-decay * duration) * std::sin(swing * duration);
    const double found = state_after(std::move(scene), 5, 400).position.z() - start;
    CHECK(found == Approx(heave).epsilon(1e-8));
}
