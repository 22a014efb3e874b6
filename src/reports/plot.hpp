#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree {

/// A line of points.
struct Series {
    std::string title;
    std::vector<std::pair<double, double>> points;
    bool dashed = false;
};

struct Plot {
    std::string title, x_label, y_label;
    std::vector<Series> series;  ///< on logarithmic axes: points at or below zero are left out
};

/// Whether pictures can be drawn: gnuplot is there.
bool can_plot();

/// Draws it as SVG. Returns false where there is nothing to draw or nothing to draw it with.
bool draw(const Plot& plot, const std::filesystem::path& file);

}  // namespace scree
