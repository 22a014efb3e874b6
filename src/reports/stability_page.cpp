#include <algorithm>
#include <map>

#include "pages.hpp"
#include "plot.hpp"
#include "stability.hpp"

namespace scree {

namespace {

/// The column of a row: the method, and what of it differs from the others of the same name.
std::string label_of(const Table& table, const Row& row) {
    const std::string& method = table.at(row, "method");
    const bool fixed = method.starts_with("bdf") && table.at(row, "step") != "adaptive";
    const bool best = table.at(row, "settings").find("separating") != std::string::npos;
    return together({method, fixed ? ", fixed" : "", best ? ", best" : ""});
}

std::string verdict_of(const Table& table, const Row& row) {
    const std::string& status = table.at(row, "status");
    const std::string silent = status != "stable" && table.at(row, "told").empty() ? ", silent" : "";
    const std::string number = shown(table.number(row, "number"));
    return together({status, " ", number,
                     status == "stable" ? "" : together({" (", table.at(row, "decided_by"), ")"}), silent});
}

/// One row a case, one column a method.
std::vector<Row> matrix(const Table& table) {
    Row methods;
    std::vector<std::pair<std::string, std::map<std::string, std::string>>> cases;
    for (const Row& row : table.rows()) {
        const std::string label = label_of(table, row);
        const std::string name = together({table.at(row, "axis"), " ", table.at(row, "value")});
        if (std::find(methods.begin(), methods.end(), label) == methods.end()) {
            methods.push_back(label);
        }
        if (cases.empty() || cases.back().first != name) {
            cases.push_back({name, {}});
        }
        cases.back().second[label] = verdict_of(table, row);
    }
    std::vector<Row> rows = {{"case"}};
    rows[0].insert(rows[0].end(), methods.begin(), methods.end());
    for (auto& [name, cells] : cases) {
        Row& row = rows.emplace_back(Row{name});
        for (const std::string& method : methods) {
            row.push_back(cells[method]);
        }
    }
    return rows;
}

std::vector<Row> counts(const Table& table) {
    std::map<std::string, std::map<std::string, int>> by_method;
    for (const Row& row : table.rows()) {
        std::map<std::string, int>& count = by_method[label_of(table, row)];
        ++count[table.at(row, "status")];
        count["silent"] += table.at(row, "status") != "stable" && table.at(row, "told").empty() ? 1 : 0;
    }
    const Row words = {"stable", "inaccurate", "failed", "stopped", "silent"};
    std::vector<Row> rows = {
        {"method", "stable", "inaccurate", "failed", "stopped", "of the last three, told by nothing"}};
    for (auto& [method, count] : by_method) {
        Row& row = rows.emplace_back(Row{method});
        for (const std::string& word : words) {
            row.push_back(std::to_string(count[word]));
        }
    }
    return rows;
}

std::vector<Row> steps_by_modulus(const Table& table, Plot& plot) {
    Row moduli;
    std::map<std::string, std::map<std::string, std::string>> by_method;
    std::map<std::string, Series> series;
    for (const Row& row : table.rows()) {
        const std::string& method = table.at(row, "method");
        const std::string& modulus = table.at(row, "Y");
        if (std::find(moduli.begin(), moduli.end(), modulus) == moduli.end()) {
            moduli.push_back(modulus);
        }
        by_method[method][modulus] =
            together({table.at(row, "limit") == "none found" ? "≥ " : "", shown(table.number(row, "step"))});
        series[method].title = method;
        series[method].points.emplace_back(table.number(row, "Y"), table.number(row, "step"));
    }
    for (auto& [method, line] : series) {
        std::sort(line.points.begin(), line.points.end());
        plot.series.push_back(line);
    }
    std::vector<Row> rows = {{"method \\ Y [Pa]"}};
    rows[0].insert(rows[0].end(), moduli.begin(), moduli.end());
    for (auto& [method, steps] : by_method) {
        Row& row = rows.emplace_back(Row{method});
        for (const std::string& modulus : moduli) {
            row.push_back(steps[modulus]);
        }
    }
    return rows;
}

void add_steps(const std::filesystem::path& folder, const Table& steps, Page& page) {
    Plot plot{"greatest stable step of a cube at rest", "Y [Pa]", "step [s]", {}};
    const std::vector<Row> rows = steps_by_modulus(steps, plot);
    page.heading(3, "Greatest stable step");
    page.text(
        "With which a cube of 0.1 m stays at rest for 400 steps, in seconds; the search ends at 0.1 s.");
    if (draw(plot, folder / "stable_steps.svg")) {
        page.picture("stable_steps.svg", "Greatest stable step over Young's modulus.");
    }
    page.table(rows);
}

}  // namespace

void add_stability(const std::filesystem::path& folder, Page& page) {
    const Table table = stability_table(folder);
    const Table steps = stable_steps_table(folder);
    if (table.rows().empty() && steps.rows().empty()) {
        return;
    }
    page.heading(2, "Stability");
    page.text(
        "Stiff and extreme cases. Stable: the run finished, invented no energy and ended right within the "
        "limit in stability.csv; inaccurate: it finished and ended farther off; failed: it did not finish, "
        "invented more than a tenth of the energy in the scene, or ended off by a body's size or all of a "
        "velocity; stopped: it took longer than it was given. The number decided it. Silent: neither a "
        "message nor the energy residual of the run told of it. stability.csv has the residuals of energy "
        "and momentum, the energy invented and the largest overlap.");
    page.text(
        "Explicit methods get a fixed number of steps for the time that a case takes, Bullet's solver its "
        "default of 1/240 s and ten iterations, and as its best a thousandth of a second, 50 iterations and "
        "separating axes.");
    if (!table.rows().empty()) {
        page.table(counts(table)).table(matrix(table));
    }
    if (!steps.rows().empty()) {
        add_steps(folder, steps, page);
    }
}

}  // namespace scree
