#include "plot.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "table.hpp"

namespace scree {

namespace {

constexpr const char* colours[] = {"#c0392b", "#2471a3", "#1e8449", "#b9770e", "#7d3c98",
                                   "#117a65", "#515a5a", "#d35400", "#2e4053", "#a569bd"};

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        result.append(c == '"' || c == '\\' ? 1 : 0, '\\').append(1, c);
    }
    result += '"';
    return result;
}

bool drawable(const std::pair<double, double>& point) {
    return point.first > 0 && point.second > 0;
}

std::string data_of(const Series& series, std::size_t number) {
    std::string text = together({"$data", std::to_string(number), " << EOD\n"});
    for (const auto& point : series.points) {
        if (drawable(point)) {
            text += together({cell(point.first), " ", cell(point.second), "\n"});
        }
    }
    text += "EOD\n";
    return text;
}

std::string script_of(const Plot& plot, const std::vector<Series>& series,
                      const std::filesystem::path& file) {
    std::string text =
        "set terminal svg size 960,500 font \"sans-serif,13\" background \"white\" dynamic\n"
        "set logscale xy\nset format \"10^{%L}\"\nset grid lc rgb \"#dddddd\"\nset border 3\n"
        "set tics nomirror\nset key outside right top samplen 2 font \",11\"\n";
    text += together({"set output ", quoted(file.string()), "\nset title ", quoted(plot.title),
                      " noenhanced\nset xlabel ", quoted(plot.x_label), "\nset ylabel ", quoted(plot.y_label),
                      "\n"});
    std::string lines;
    for (std::size_t i = 0; i < series.size(); ++i) {
        text += data_of(series[i], i);
        lines +=
            together({lines.empty() ? "plot " : ", ", "$data", std::to_string(i), " with linespoints pt ",
                      std::to_string(4 + i % 10), " ps 0.6 lc rgb \"", colours[i % std::size(colours)], "\"",
                      series[i].dashed ? " dt 2" : "", " title ", quoted(series[i].title), " noenhanced"});
    }
    return together({text, lines, "\n"});
}

}  // namespace

bool can_plot() {
    static const bool found = std::system("gnuplot --version >/dev/null 2>&1") == 0;
    return found;
}

bool draw(const Plot& plot, const std::filesystem::path& file) {
    std::vector<Series> series;
    std::copy_if(plot.series.begin(), plot.series.end(), std::back_inserter(series), [](const Series& each) {
        return std::any_of(each.points.begin(), each.points.end(), drawable);
    });
    if (series.empty() || !can_plot()) {
        return false;
    }
    std::FILE* gnuplot = popen("gnuplot 2>/dev/null", "w");
    if (gnuplot == nullptr) {
        return false;
    }
    const std::string script = script_of(plot, series, file);
    const bool written = std::fwrite(script.data(), 1, script.size(), gnuplot) == script.size();
    const int status = pclose(gnuplot);
    return written && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace scree
