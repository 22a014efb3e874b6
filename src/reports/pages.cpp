#include "pages.hpp"

#include <cmath>
#include <cstdio>

#include <scree/output/output_folder.hpp>

#include "accuracy.hpp"
#include "claims.hpp"
#include "comparison.hpp"
#include "cost.hpp"
#include "plot.hpp"
#include "stability.hpp"

namespace scree {

namespace {

std::string markdown_of(const std::vector<Row>& rows) {
    return rows.empty() ? "" : Page().table(rows).markdown();
}

void add_standings(const Table& table, const std::vector<Problem>& problems, std::vector<Row>& rows) {
    for (const Problem& problem : problems) {
        const std::vector<Work> work = finished_work(table, problem.name);
        const Work* best = most_exact(work, true);
        const Work* own = best == nullptr ? most_exact(work, false) : most_exact(work, false, best->seconds);
        if (own == nullptr) {
            continue;
        }
        const std::string ours = together({shown(own->error), " in ", shown(own->seconds), " s"});
        const std::string other =
            best == nullptr ? "–" : together({shown(best->error), " in ", shown(best->seconds), " s"});
        rows.push_back({together({problem.name, ": error and run time"}), ours, other,
                        best == nullptr ? "" : standing(work).verdict});
    }
}

void add_claims(const Table& table, std::vector<Row>& rows) {
    for (const Row& row : table.rows()) {
        const double value = table.number(row, "value");
        rows.push_back({table.at(row, "claim"), together({shown(value), " ", table.at(row, "unit")}), "",
                        table.at(row, "how")});
    }
}

void add_stable_cells(const Table& table, std::vector<Row>& rows) {
    const auto stable_of = [&](const std::string& method, bool adaptive) {
        int stable = 0;
        int all = 0;
        for (const Row& row : table.rows()) {
            if (table.at(row, "method") == method && (table.at(row, "step") == "adaptive") == adaptive &&
                table.at(row, "axis") != "step") {
                ++all;
                stable += table.at(row, "status") == "stable" ? 1 : 0;
            }
        }
        return together({std::to_string(stable), " of ", std::to_string(all)});
    };
    if (!table.rows().empty()) {
        rows.push_back({"extreme cases stable: bdf2 adaptive; Bullet, defaults and best",
                        stable_of("bdf2", true), stable_of("bullet", false), ""});
        rows.push_back({"extreme cases stable: velocity Verlet", stable_of("verlet", false), "", ""});
    }
}

void add_steps(const Table& table, std::vector<Row>& rows) {
    for (const Row& row : table.rows()) {
        const std::string& method = table.at(row, "method");
        if ((method == "bdf2" || method == "verlet") && table.at(row, "Y") == "1e+11") {
            const bool open = table.at(row, "limit") == "none found";
            rows.push_back(
                {together({"greatest stable step of ", method, " at Y = 1e11 Pa"}),
                 together({open ? "0.1 s and more" : shown(table.number(row, "step")), open ? "" : " s"}), "",
                 ""});
        }
    }
}

void add_costs(const Table& table, std::vector<Row>& rows) {
    for (const Row& row : table.rows()) {
        if (table.at(row, "status") == "done" && table.at(row, "method") == "bdf2" &&
            table.at(row, "rtol") == "0.01") {
            rows.push_back({together({"one evaluation of a contact in ", table.at(row, "scene"), ", bdf2"}),
                            together({shown(table.number(row, "us_per_evaluation")), " µs"}), "", ""});
        }
    }
}

}  // namespace

std::string shown(double value) {
    if (!std::isfinite(value)) {
        return "–";
    }
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.2g", value);
    return digits;
}

std::vector<Row> headline(const std::filesystem::path& folder, const std::vector<Problem>& problems) {
    std::vector<Row> rows = {{"what", "scree", "Bullet's most exact", "how, or how scree stands"}};
    add_claims(claims_table(folder), rows);
    add_standings(accuracy_table(folder), problems, rows);
    add_stable_cells(stability_table(folder), rows);
    add_steps(stable_steps_table(folder), rows);
    add_costs(stages_table(folder), rows);
    return rows.size() == 1 ? std::vector<Row>() : rows;
}

void write_pages(const std::filesystem::path& folder, const std::vector<Problem>& problems,
                 const std::vector<Row>& about) {
    Page page;
    page.heading(1, "scree: accuracy, stability and cost").table(about);
    if (!can_plot()) {
        page.text("There are no pictures: gnuplot is not installed.");
    }
    const std::vector<Row> figures = headline(folder, problems);
    if (!figures.empty()) {
        page.heading(2, "In short").table(figures);
    }
    add_accuracy(folder, problems, page);
    add_stability(folder, page);
    add_cost(folder, page);
    write_whole(folder / "index.html", page.html("scree: accuracy, stability and cost"));
    write_whole(folder / "report.md", page.markdown());
    write_whole(folder / "headline.md", markdown_of(figures));
}

}  // namespace scree
