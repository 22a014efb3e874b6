#include <algorithm>
#include <cmath>
#include <map>

#include "accuracy.hpp"
#include "comparison.hpp"
#include "pages.hpp"
#include "plot.hpp"

namespace scree {

namespace {

constexpr double asked_errors[] = {0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

std::string seconds_of(const Work* work) {
    return work == nullptr ? "not reached" : together({shown(work->seconds), " s: ", work->label});
}

std::vector<Row> standings(const Table& table, const std::vector<Problem>& problems) {
    std::vector<Row> rows = {{"problem", "Bullet's least error", "takes [s]", "scree in that time or less",
                              "scree to that error [s]", "Bullet's rows beaten", "scree is"}};
    for (const Problem& problem : problems) {
        const std::vector<Work> work = finished_work(table, problem.name);
        if (work.empty()) {
            continue;
        }
        const Standing stands = standing(work);
        const Work* best = most_exact(work, true);
        Row row = {problem.name, "–", "–", "–", "–", "–", stands.verdict};
        if (best != nullptr) {
            const Work* rival = most_exact(work, false, best->seconds);
            const Work* quick = fastest(work, false, best->error);
            row = {problem.name,
                   shown(best->error),
                   shown(best->seconds),
                   rival == nullptr ? "–" : shown(rival->error),
                   quick == nullptr ? "not reached" : shown(quick->seconds),
                   together({std::to_string(stands.beaten), " of ", std::to_string(stands.bullet_rows)}),
                   stands.verdict};
        }
        rows.push_back(row);
    }
    return rows;
}

std::vector<Row> costs_of_errors(const std::vector<Work>& work) {
    std::vector<Row> rows = {{"error at most", "scree", "Bullet"}};
    for (const double error : asked_errors) {
        const Work* own = fastest(work, false, error);
        const Work* other = fastest(work, true, error);
        if (own != nullptr || other != nullptr) {
            rows.push_back({cell(error), seconds_of(own), seconds_of(other)});
        }
    }
    return rows;
}

/// Those that did not come to the right end, and how.
std::vector<Row> failures(const Table& table, const std::string& problem) {
    std::vector<Row> rows = {{"method", "step", "rtol", "settings", "status", "how"}};
    for (const Row& row : table.rows()) {
        const std::string& status = table.at(row, "status");
        if (table.at(row, "problem") != problem || status == "done") {
            continue;
        }
        const std::string off =
            together({table.at(row, "worst"), " off by ", shown(table.number(row, "error"))});
        rows.push_back({table.at(row, "method"), table.at(row, "step"), table.at(row, "rtol"),
                        table.at(row, "settings"), status,
                        status == "wrong" ? off : table.at(row, "message")});
    }
    return rows;
}

Plot plot_of(const std::vector<Work>& work, const std::string& title, double Work::*error) {
    std::map<std::string, Series> by_family;
    for (const Work& each : work) {
        Series& series = by_family[each.family];
        series.title = each.family;
        series.dashed = each.by_bullet;
        series.points.emplace_back(each.seconds, each.*error);
    }
    Plot plot{title, "run time [s]", "error", {}};
    for (auto& [family, series] : by_family) {
        std::sort(series.points.begin(), series.points.end());
        plot.series.push_back(series);
    }
    return plot;
}

void add_pictures(const std::filesystem::path& folder, const Problem& problem, const std::vector<Work>& work,
                  Page& page) {
    const std::string first = together({"accuracy_", problem.name, ".svg"});
    const std::string second = together({"numerical_", problem.name, ".svg"});
    if (draw(plot_of(work, together({problem.name, ": error"}), &Work::error), folder / first)) {
        page.picture(
            first, together({"Error against run time: ", problem.name, ". Broken lines: Bullet's solver."}));
    }
    if (problem.rigid && !problem.free_flight &&
        draw(plot_of(work, together({problem.name, ": numerical error against the force model"}),
                     &Work::numerical_error),
             folder / second)) {
        page.picture(second,
                     together({"Numerical error, against the model's own outcome: ", problem.name, "."}));
    }
}

std::string reference_text(const Problem& problem, const Reference& reference) {
    if (!reference.known()) {
        return "The methods that were to agree on the model's outcome did not finish, so that numerical "
               "errors are not known.";
    }
    const std::string source =
        problem.model
            ? "The model's outcome is in closed form."
            : together({problem.chaotic ? "The fine runs differ from their mean by up to "
                                        : "Two methods at their finest agree on the model's outcome to ",
                        shown(reference.agreement), "."});
    const bool apart = std::isfinite(reference.model_error) && reference.model_error > 0;
    return apart ? together({source, " The model differs from rigid bodies by ", shown(reference.model_error),
                             "."})
                 : source;
}

}  // namespace

void add_accuracy(const std::filesystem::path& folder, const std::vector<Problem>& problems, Page& page) {
    const Table table = accuracy_table(folder);
    if (table.rows().empty()) {
        return;
    }
    const Table references = reference_table(folder);
    page.heading(2, "Accuracy");
    page.text(
        "Every problem by every method: its error over its run time, the least of several runs after one "
        "that warms up, without loading. The error is against rigid bodies under Coulomb's law where these "
        "have an answer; numerical_error in accuracy.csv is against the force model itself, and model_error "
        "is what the model differs from rigid bodies. A row of Bullet's is beaten when scree takes no longer "
        "to no larger an error.");
    page.table(standings(table, problems));
    for (const Problem& problem : problems) {
        const std::vector<Work> work = finished_work(table, problem.name);
        const std::vector<Row> failed = failures(table, problem.name);
        if (work.empty() && failed.size() == 1) {
            continue;
        }
        page.heading(3, problem.name).text(problem.purpose);
        page.text(reference_text(problem, reference_of(problem, references)));
        add_pictures(folder, problem, work, page);
        page.table(costs_of_errors(work));
        if (failed.size() > 1) {
            page.text("Not come to the right end:").table(failed);
        }
    }
}

}  // namespace scree
