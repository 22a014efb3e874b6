// The closed forms of the problems, against each other and against fine runs.

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <src/reports/disc_friction.hpp>
#include <src/reports/reference.hpp>

using namespace scree;

namespace {

/// Against the force model's closed form, else against rigid bodies.
double error_of(const Problem& problem, const MethodChoice& method) {
    const Observation seen = observe_run(problem, method, {60});
    INFO(problem.name << ": " << seen.message);
    REQUIRE(seen.finished);
    REQUIRE(seen.times == looking_times(problem));
    double worst = 0;
    for (std::size_t i = 0; i < seen.times.size(); ++i) {
        const Values exact = problem.model ? problem.model(seen.times[i]) : problem.rigid(seen.times[i]);
        worst = std::max(worst, largest_difference(seen.samples[i], exact).value);
    }
    return worst;
}

/// Friction on a ring-by-ring, wedge-by-wedge disc of radius 1 that turns at 1: the force along its motion at
/// `ratio` and the moment, over μ N.
std::pair<double, double> summed_friction(double ratio) {
    constexpr int rings = 400;
    constexpr int wedges = 400;
    double force = 0;
    double moment = 0;
    for (int i = 0; i < rings; ++i) {
        const double r = (i + 0.5) / rings;
        for (int j = 0; j < wedges; ++j) {
            const double angle = 2 * std::numbers::pi * (j + 0.5) / wedges;
            const double x = ratio - r * std::sin(angle);
            const double y = r * std::cos(angle);
            const double share = 2 * r / (rings * wedges) / std::hypot(x, y);
            force += share * x;
            moment += share * r * (y * std::cos(angle) - x * std::sin(angle));
        }
    }
    return {force, moment};
}

}  // namespace

TEST_CASE("Friction under a disc: elliptic integrals are the sum over its base", "[reports]") {
    for (const double ratio : {0.05, 0.3, 0.653, 0.99, 1.01, 2.0, 20.0}) {
        const auto [force, moment] = summed_friction(ratio);
        CAPTURE(ratio);
        CHECK(disc_force(ratio) == Approx(force).margin(1e-3));
        CHECK(disc_moment(ratio) == Approx(moment).margin(1e-3));
    }
    // Pure turning and pure sliding, and the continuation beyond the formulas' ends.
    CHECK(disc_moment(1e-6) == Approx(2.0 / 3));
    CHECK(disc_force(1e6) == Approx(1));
    CHECK(disc_force(1e-3 - 1e-9) == Approx(disc_force(1e-3 + 1e-9)).epsilon(1e-4));
    CHECK(disc_moment(100 - 1e-6) == Approx(disc_moment(100 + 1e-6)).epsilon(1e-2));
}

TEST_CASE("A disc stops sliding and spinning at once, at v = 0.653 R ω", "[reports]") {
    // There the ratio stays: d(v/(R ω))/dt = 0 where the force is twice the ratio times the moment.
    double low = 0.1;
    double high = 0.99;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (disc_force(middle) - 2 * middle * disc_moment(middle) > 0 ? high : low) = middle;
    }
    CHECK(low == Approx(0.653).margin(1e-3));
    const Problem problem = sliding_disc_problem();
    const Values last = problem.rigid(problem.scene.end_time);
    CHECK(largest_difference(last, problem.rigid(2 * problem.scene.end_time)).value < 1e-6);
}

TEST_CASE("Problems with a closed form come out as it says", "[reports]") {
    CHECK(error_of(free_top_problem(true), adaptive_bdf(5, 1e-9)) < 1e-6);
    CHECK(error_of(bounce_problem(), adaptive_bdf(5, 1e-8)) < 1e-5);
    CHECK(error_of(mass_ratio_problem(), adaptive_bdf(2, 1e-6)) < 1e-8);
    CHECK(error_of(rolling_problem(), adaptive_bdf(2, 1e-6)) < 5e-3);
    CHECK(error_of(sliding_to_rest_problem(), adaptive_bdf(2, 1e-6)) < 1e-4);
}

TEST_CASE("The rigid outcomes start where the scenes do", "[reports]") {
    for (const Problem& problem : accuracy_problems(true)) {
        CAPTURE(problem.name);
        CHECK_FALSE(problem.purpose.empty());
        CHECK(problem.quantities.size() > 0);
        CHECK((problem.model || problem.references.size() >= 2));
        CHECK_NOTHROW(Simulation(problem.scene));
        if (problem.rigid && !problem.last_only) {
            CHECK(problem.rigid(0).size() == problem.quantities.size());
        }
    }
}

TEST_CASE("Two methods that share no step agree on the cradle", "[reports]") {
    const Problem problem = cradle_problem();
    const Observation implicit = observe_run(problem, adaptive_bdf(2, 1e-6), {60});
    const Observation direct = observe_run(problem, explicit_method(SteppingMethod::verlet, 1e-6), {60});
    REQUIRE(implicit.finished);
    REQUIRE(direct.finished);
    CHECK(largest_difference(implicit.samples, direct.samples).value < 1e-5);
}

TEST_CASE("Samples are read from a table as they were", "[reports]") {
    const std::vector<Values> samples = {{1.0 / 3, -2e-300}, {0, 4}};
    CHECK(unpacked_samples(packed_samples(samples)) == samples);
    CHECK(unpacked_samples("").empty());
}
