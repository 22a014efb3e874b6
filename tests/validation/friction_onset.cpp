// How friction sets in, Fig. 5.16 of the source: a tile let go on a slope that holds it.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>
#include <scree/scenes/friction_onset.hpp>

using namespace scree;

namespace {

double worst_error(const FrictionOnset& onset, const OnsetRun& run) {
    double worst = 0;
    for (std::size_t i = 0; i < run.time.size(); ++i) {
        worst = std::max(worst, std::abs(run.spring[i] - onset_spring(onset, run.time[i])));
    }
    return worst;
}

// Each step's equations are solved to 10⁻¹² of √(gℓ), 10⁻¹³ m/s, and the spring of the stiffest swings at
// 10⁻⁵ m/s.
constexpr double rounding = 1e-8;

double largest_fall(const std::vector<double>& values) {
    double largest = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        largest = std::max(largest, values[i - 1] - values[i]);
    }
    return largest;
}

// The time [s] between the first and the last of the spring's rises through the pull, over their number.
double measured_period(const OnsetRun& run) {
    double first = 0;
    double last = 0;
    int rises = 0;
    for (std::size_t i = 1; i < run.time.size(); ++i) {
        if (run.spring[i - 1] < 1 && run.spring[i] >= 1) {
            const double part = (1 - run.spring[i - 1]) / (run.spring[i] - run.spring[i - 1]);
            last = run.time[i - 1] + part * (run.time[i] - run.time[i - 1]);
            first = rises == 0 ? last : first;
            ++rises;
        }
    }
    REQUIRE(rises >= 4);
    return (last - first) / (rises - 1);
}

// Stiffnesses over three decades, by Y, by Yt/Y and by the choice of the spring.
std::vector<FrictionOnset> stiffnesses(double damping) {
    std::vector<FrictionOnset> onsets;
    for (const double modulus : {1e7, 1e8, 1e10}) {
        onsets.push_back({damping, 2.0 / 7, modulus, {}});
    }
    onsets.push_back({damping, 0.9, 1e8, {}});
    onsets.push_back({damping, 2.0 / 7, 1e8, {.tangential_stiffness = TangentialStiffness::no_length}});
    onsets.push_back({damping, 2.0 / 7, 1e8, {.tangential_stiffness = TangentialStiffness::patch}});
    return onsets;
}

}  // namespace

TEST_CASE("Fig. 5.16: without damping the spring swings about the pull with ω = √(kt/m)", "[laws]") {
    for (const FrictionOnset& onset : stiffnesses(0)) {
        CAPTURE(onset.youngs_modulus, onset_frequency(onset));
        const OnsetRun run = run_friction_onset(onset, 5, 200);
        REQUIRE(run.time.size() > 990);
        CHECK_FALSE(run.slipped);
        const double exact = 2 * std::numbers::pi / onset_frequency(onset);
        CHECK(measured_period(run) == Approx(exact).epsilon(1e-3));
        CHECK(*std::max_element(run.spring.begin(), run.spring.end()) == Approx(2).epsilon(1e-3));
        CHECK(worst_error(onset, run) < 0.02);  // it rocks a little, the more the stiffer its spring
    }
}

TEST_CASE("Fig. 5.16: with damping enough the spring's force rises monotonely to the pull", "[laws]") {
    for (const double damping : {2.0, 3.0}) {
        for (FrictionOnset onset : stiffnesses(damping)) {
            onset.law.reduced_mass = ReducedMass::exact;
            if (onset.law.tangential_stiffness == TangentialStiffness::no_length) {
                continue;  // its damping has Lc and does not go with its stiffness
            }
            CAPTURE(damping, onset.youngs_modulus);
            const OnsetRun run = run_friction_onset(onset, 5, 200);
            CHECK(largest_fall(run.spring) < rounding);
            CHECK(run.spring.back() == Approx(1).epsilon(1e-3));
            CHECK(worst_error(onset, run) < 5e-3);
        }
    }
}

TEST_CASE("Fig. 5.16: the friction lags by a time that falls as 1/√kt", "[laws]") {
    // The undamped spring carries the pull after a quarter of its period.
    double last = std::numeric_limits<double>::infinity();
    for (const double modulus : {1e7, 1e8, 1e9, 1e10}) {
        const FrictionOnset onset{0, 2.0 / 7, modulus, {}};
        const double delay = onset_delay(run_friction_onset(onset, 1, 400), 1);
        CHECK(delay * onset_frequency(onset) == Approx(std::numbers::pi / 2).epsilon(1e-3));
        CHECK(delay < last);
        last = delay;
    }
    CHECK(std::isnan(onset_delay(run_friction_onset({2, 2.0 / 7, 1e8, {}}, 1, 50), 1)));
}
