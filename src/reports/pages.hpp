#pragma once

#include "page.hpp"
#include "problem.hpp"

namespace scree {

// The parts of the page, each from the tables in its folder; a part without a table is left out.

void add_accuracy(const std::filesystem::path& folder, const std::vector<Problem>& problems, Page& page);
void add_stability(const std::filesystem::path& folder, Page& page);
void add_cost(const std::filesystem::path& folder, Page& page);

/// The most telling figures, as a table with a header; empty without tables.
std::vector<Row> headline(const std::filesystem::path& folder, const std::vector<Problem>& problems);

/// index.html, report.md and headline.md, with pictures where gnuplot is there. Throws OutputError.
void write_pages(const std::filesystem::path& folder, const std::vector<Problem>& problems,
                 const std::vector<Row>& about);

/// A number for a reader: two digits.
std::string shown(double value);

}  // namespace scree
