#include <algorithm>
#include <map>

#include "cost.hpp"
#include "pages.hpp"
#include "plot.hpp"

namespace scree {

namespace {

/// The table without some of its columns, numbers shortened.
std::vector<Row> readable(const Table& table, const std::vector<std::string>& without) {
    const auto hidden = [&](const std::string& name) {
        return std::find(without.begin(), without.end(), name) != without.end();
    };
    std::vector<Row> rows(1);
    for (const std::string& name : table.columns()) {
        if (!hidden(name)) {
            rows[0].push_back(name);
        }
    }
    for (const Row& row : table.rows()) {
        Row& line = rows.emplace_back();
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (!hidden(table.columns()[i])) {
                const bool small =
                    row[i].find('.') != std::string::npos || row[i].find('e') != std::string::npos;
                const double value = number_in(row[i]);
                line.push_back(small && value == value ? shown(value) : row[i]);
            }
        }
    }
    return rows;
}

void add_scaling_pictures(const std::filesystem::path& folder, const Table& table, Page& page) {
    for (const char* by : {"bodies", "vertices", "threads"}) {
        std::map<std::string, Series> series;
        for (const Row& row : table.rows()) {
            if (table.at(row, "by") == by) {
                Series& line = series[table.at(row, "method")];
                line.title = table.at(row, "method");
                line.points.emplace_back(table.number(row, "value"), table.number(row, "seconds_per_step"));
            }
        }
        Plot plot{together({"time of a step over ", by}), by, "a step [s]", {}};
        for (auto& [method, line] : series) {
            plot.series.push_back(line);
        }
        const std::string file = together({"scaling_", by, ".svg"});
        if (draw(plot, folder / file)) {
            page.picture(file, together({"Time of a step over ", by, "."}));
        }
    }
}

/// What the scene with the need enters and the one without does not.
std::string difference(const std::string& with, const std::string& without) {
    std::string text;
    std::size_t begin = 0;
    while (begin < with.size()) {
        const std::size_t end = std::min(with.find(' ', begin), with.size());
        const std::string word = with.substr(begin, end - begin);
        if (together({" ", without, " "}).find(together({" ", word, " "})) == std::string::npos) {
            text += together({text.empty() ? "" : " ", word});
        }
        begin = end + 1;
    }
    return text;
}

std::vector<Row> pairs_of(const Table& table) {
    std::vector<Row> rows = {{"need", "entered with it alone", "Newton iterations", "Jacobians", "functional",
                              "contact evaluations", "heap [bytes]", "written [bytes]", "loading [s]",
                              "time [s]", "time without"}};
    std::map<std::string, const Row*> with;
    for (const Row& row : table.rows()) {
        const std::string& need = table.at(row, "need");
        if (table.at(row, "side") == "with") {
            with[need] = &row;
            continue;
        }
        if (with[need] == nullptr) {
            continue;
        }
        const Row& other = *with[need];
        Row line = {need, difference(table.at(other, "entered"), table.at(row, "entered"))};
        for (const char* name :
             {"newton", "jacobians", "functional", "evaluations", "bytes", "written", "loading"}) {
            line.push_back(together({table.at(other, name), " / ", table.at(row, name)}));
        }
        line.push_back(together({table.at(other, "seconds"), " / ", table.at(row, "seconds")}));
        line.push_back(shown(table.number(row, "seconds") / table.number(other, "seconds")));
        rows.push_back(line);
    }
    return rows;
}

void add_scaling(const std::filesystem::path& folder, const Table& scaling, Page& page) {
    page.heading(3, "Scaling");
    page.text(
        "Stones in a lattice in which neighbours overlap, as one group; memory a body is that of the same "
        "lattice with nothing in touch, less what one body takes, and memory a contact what touching adds.");
    add_scaling_pictures(folder, scaling, page);
    page.table(readable(scaling, {}));
}

void add_left_out(const std::filesystem::path& folder, const Table& left_out, Page& page) {
    page.heading(3, "What is left out");
    page.text(
        "Pairs of scenes that differ in one need; where there are two numbers, the first is with it. Parts "
        "of the law that a scene does not enter are not compiled into its loop: each choice is a type of its "
        "own. Rotation is never left out; the pair shows that bodies that do not turn cost the same. Of the "
        "heap the most part are pools that Bullet's collision configuration takes at once, which the "
        "spheres' scene has, too.");
    page.table(pairs_of(left_out));
    page.text(
        "The program links all components, and so has the same libraries in both of a pair; a program of "
        "one's own links what its components need:");
    page.table(readable(libraries_table(folder), {}));
    page.text(
        together({"In the process of these runs: ", left_out.at(left_out.rows().front(), "libraries")}));
}

}  // namespace

void add_cost(const std::filesystem::path& folder, Page& page) {
    const Table stages = stages_table(folder);
    const Table scaling = scaling_table(folder);
    const Table left_out = left_out_table(folder);
    if (stages.rows().empty() && scaling.rows().empty() && left_out.rows().empty()) {
        return;
    }
    page.heading(2, "Cost");
    if (!stages.rows().empty()) {
        page.heading(3, "Stages");
        page.text("Wall time [s] of the steps by stage, and microseconds for one evaluation of one contact.");
        page.table(readable(stages, {}));
    }
    if (!scaling.rows().empty()) {
        add_scaling(folder, scaling, page);
    }
    if (!left_out.rows().empty()) {
        add_left_out(folder, left_out, page);
    }
}

}  // namespace scree
