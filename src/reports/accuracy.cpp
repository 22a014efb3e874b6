#include "accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace scree {

namespace {

const Row columns = {"problem", "method",          "step",        "rtol",  "error",   "seconds", "settings",
                     "status",  "numerical_error", "model_error", "worst", "reached", "steps",   "runs",
                     "message"};
const Row keys = {"problem", "method", "step", "rtol", "settings"};

constexpr double size_off = 0.5;        // an error with which the end is plainly not the right one
constexpr std::size_t fewest_runs = 3;  // besides the one that warms up, if there is time
constexpr std::size_t most_runs = 8;
constexpr double enough_time = 0.2;  // [s], of runs that are timed

Row row_keys(const Problem& problem, const MethodChoice& method) {
    return {problem.name, method.name(), method.step(), method.rtol(), method.settings()};
}

/// The family of methods that differ in their step or tolerance alone.
std::string family(const MethodChoice& method) {
    return method.name() + "," + method.settings() + (method.stepping.step ? ",fixed" : ",adaptive");
}

/// Least time [s] of runs after a first one, and how many there were.
struct Timing {
    double seconds = std::numeric_limits<double>::infinity();
    std::size_t runs = 0;
};

Timing timed(const Problem& problem, const MethodChoice& method, double first, const Budget& budget) {
    Timing timing;
    double spent = 0;
    while ((timing.runs < fewest_runs || (spent < enough_time && timing.runs < most_runs)) &&
           spent + first < budget.seconds) {
        const Observation seen = observe_run(problem, method, budget);
        timing.seconds = std::min(timing.seconds, seen.seconds);
        spent += seen.seconds;
        ++timing.runs;
    }
    if (timing.runs == 0) {
        timing = {first, 1};  // so long that there was no more to warm up
    }
    return timing;
}

std::string status_of(const Observation& seen, double error) {
    if (seen.finished) {
        return error > size_off || std::isnan(error) ? "wrong" : "done";
    }
    return seen.message.starts_with("stopped") ? "stopped" : "failed";
}

Row unfinished_row(const Problem& problem, const MethodChoice& method, const std::string& status,
                   const std::string& message) {
    Row row = {problem.name, method.name(), method.step(), method.rtol(), "", "", method.settings(), status};
    row.insert(row.end(), {"", "", "", "", "", ""});
    row.push_back(message);
    return row;
}

Row measured(const Problem& problem, const MethodChoice& method, const Reference& reference,
             const Budget& budget) {
    const Observation seen = observe_run(problem, method, budget);
    if (!seen.finished) {
        Row row = unfinished_row(problem, method, status_of(seen, 0), seen.message);
        row[11] = cell(seen.reached);
        return row;
    }
    const double none = std::numeric_limits<double>::quiet_NaN();
    const bool rigid = static_cast<bool>(problem.rigid);
    const Difference against_model = largest_difference(seen.samples, reference.samples);
    const Difference error = rigid ? largest_difference(seen.samples, rigid_samples(problem)) : against_model;
    const bool has_model = reference.known() && (!method.by_bullet() || !rigid);
    const Timing timing = timed(problem, method, seen.seconds, budget);
    return {problem.name,
            method.name(),
            method.step(),
            method.rtol(),
            cell(rigid || reference.known() ? error.value : none),
            cell(timing.seconds),
            method.settings(),
            status_of(seen, error.value),
            cell(has_model ? against_model.value : none),
            cell(method.by_bullet() ? none : reference.model_error),
            problem.quantities[error.quantity],
            cell(seen.reached),
            std::to_string(seen.report.steps.accepted),
            std::to_string(timing.runs),
            ""};
}

/// Whether a longer step or a looser tolerance of the same family took too long.
bool hopeless(const Problem& problem, const MethodChoice& method, const std::vector<MethodChoice>& all,
              const Table& table) {
    for (const MethodChoice& other : all) {
        if (other.text() == method.text()) {
            return false;
        }
        const Row wanted = row_keys(problem, other);
        const auto slow = [&](const Row& row) {
            const std::string& status = table.at(row, "status");
            return Row{row[0], row[1], row[2], row[3], table.at(row, "settings")} == wanted &&
                   (status == "stopped" || status == "ended");
        };
        if (family(other) == family(method) && std::any_of(table.rows().begin(), table.rows().end(), slow)) {
            return true;
        }
    }
    return false;
}

}  // namespace

Table accuracy_table(const std::filesystem::path& folder) {
    return {folder / "accuracy.csv", columns, keys};
}

Row accuracy_row(const Problem& problem, const MethodChoice& method, const Reference& reference,
                 const Budget& budget) {
    const Isolated answer =
        isolated_row([&] { return measured(problem, method, reference, budget); }, budget);
    return answer.done ? answer.row : unfinished_row(problem, method, "ended", answer.message);
}

namespace {

/// What is not yet in the table of the runs that a problem's outcome is taken from.
void add_references(const Problem& problem, const std::shared_ptr<Table>& references, const Budget& budget,
                    std::vector<Case>& cases) {
    for (const MethodChoice& method : problem.references) {
        if (references->has(row_keys(problem, method))) {
            continue;
        }
        cases.push_back({"reference for " + problem.name + ": " + method.text(), [=] {
                             const Isolated answer =
                                 isolated_row([&] { return reference_row(problem, method, budget); }, budget);
                             Row row = row_keys(problem, method);
                             row.insert(row.end(), {answer.message, "", ""});
                             references->add(answer.done ? answer.row : row);
                         }});
    }
}

/// What is not yet in the table of the methods that are held against that.
void add_methods(const Problem& problem, const std::vector<MethodChoice>& methods,
                 const std::shared_ptr<Table>& table, const std::shared_ptr<Table>& references,
                 const Budget& budget, std::vector<Case>& cases) {
    for (const MethodChoice& method : methods) {
        if (table->has(row_keys(problem, method))) {
            continue;
        }
        cases.push_back(
            {problem.name + ": " + method.text(), [=] {
                 if (hopeless(problem, method, methods, *table)) {
                     table->add(unfinished_row(problem, method, "not run", "a coarser one took too long"));
                     return;
                 }
                 const Reference reference = reference_of(problem, *references);
                 table->add(accuracy_row(problem, method, reference, budget));
             }});
    }
}

}  // namespace

std::vector<Case> accuracy_cases(const ReportRequest& request) {
    const double seconds = request.quick ? 0.7 : 6;
    const Budget patient{request.quick ? 20.0 : 120.0};
    const auto table = std::make_shared<Table>(accuracy_table(request.out));
    const auto references = std::make_shared<Table>(reference_table(request.out));
    std::vector<Case> cases;
    for (const Problem& problem : accuracy_problems(request.quick)) {
        if (wanted(request, problem.name)) {
            const Budget budget{(problem.chaotic ? 6 : 1) * seconds};
            add_references(problem, references, patient, cases);
            add_methods(problem, accuracy_methods(problem, request.quick), table, references, budget, cases);
        }
    }
    return cases;
}

}  // namespace scree
