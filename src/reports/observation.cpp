#include "observation.hpp"

#include <algorithm>
#include <cmath>

#include <scree/mesh_io/isolated.hpp>

#include "run_clock.hpp"

namespace scree {

namespace {

bool all_finite(const Values& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// One output time further, by the clock. Returns whether to go on.
bool advance(Simulation& simulation, const Budget& budget, RunClock& clock, Observation& seen) {
    clock.start();
    const bool good = simulation.advance();
    clock.stop();
    seen.seconds = clock.seconds();
    seen.reached = simulation.time();
    if (!good) {
        seen.message = simulation.report().message;
        return false;
    }
    if (seen.seconds > budget.seconds && simulation.tick() < simulation.times().last()) {
        seen.message = "stopped after " + cell(budget.seconds) + " s of computing";
        return false;
    }
    return true;
}

bool look(const Simulation& simulation, const Problem& problem, Observation& seen) {
    if (problem.last_only && simulation.tick() < simulation.times().last()) {
        return true;
    }
    seen.times.push_back(simulation.time());
    seen.samples.push_back(problem.observe(simulation));
    if (!all_finite(seen.samples.back())) {
        seen.message = "a value is not finite";
        return false;
    }
    return true;
}

void run(Simulation& simulation, const Problem& problem, const Budget& budget, Observation& seen) {
    RunClock clock;
    while (simulation.tick() < simulation.times().last()) {
        if (!advance(simulation, budget, clock, seen) || !look(simulation, problem, seen)) {
            break;
        }
    }
    seen.finished = seen.message.empty();
    seen.report = simulation.report();
}

}  // namespace

Observation observe_run(const Problem& problem, const MethodChoice& method, const Budget& budget) {
    Observation seen;
    SceneDescription scene = problem.scene;
    method.apply(scene);
    try {
        Simulation simulation(scene);
        run(simulation, problem, budget, seen);
    } catch (const std::exception& error) {
        seen.message = error.what();
    }
    return seen;
}

Isolated isolated_row(const std::function<Row()>& work, const Budget& budget) {
    constexpr std::uintmax_t memory = std::uintmax_t{4} << 30;
    try {
        const std::string text =
            run_isolated([&] { return csv_line(work()) + "\n"; }, {budget.limit(), memory, "the program"});
        const std::vector<Row> rows = csv_rows(text);
        return rows.size() == 1 ? Isolated{true, rows.front(), ""} : Isolated{false, {}, "no answer"};
    } catch (const IsolationError& error) {
        return {false, {}, error.what()};
    }
}

Difference largest_difference(const Values& a, const Values& b) {
    Difference largest;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = std::abs(a[i] - b[i]);
        if (!(difference <= largest.value)) {  // NaN counts as the largest
            largest = {difference, i};
        }
        if (std::isnan(difference)) {
            break;
        }
    }
    return largest;
}

}  // namespace scree
