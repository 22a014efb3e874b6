#pragma once

#include <filesystem>

#include "case.hpp"
#include "observation.hpp"

namespace scree {

// Where time and memory go, and what a scene that does not need something saves.

/// A scene that was run for its cost.
struct Expense {
    bool finished = false;
    std::string message;
    double seconds = 0;  ///< of the steps, the least of several runs: RunClock's, or the clock's for threads
    double loading = 0;  ///< [s], of making the simulation
    double bytes = 0;    ///< on the heap at the end, for the simulation alone
    std::size_t files = 0;  ///< [bytes] written
    std::size_t bodies = 0;
    StepReport report;
};

/// What a run does besides.
struct Running {
    std::size_t threads = 1;
    bool write = false;           ///< the tables of bodies, energy and contacts
    std::filesystem::path place;  ///< where to
    std::size_t runs = 3;
};

Expense expense_of(const SceneDescription& scene, const Running& running, const Budget& budget);

/// Names of the shared libraries in this process, without paths.
std::string mapped_libraries();

// The tables: stages.csv, scaling.csv, left_out.csv and libraries.csv.
Table stages_table(const std::filesystem::path& folder);
Table scaling_table(const std::filesystem::path& folder);
Table left_out_table(const std::filesystem::path& folder);
Table libraries_table(const std::filesystem::path& folder);

std::vector<Case> stage_cases(const ReportRequest& request);
std::vector<Case> scaling_cases(const ReportRequest& request);
std::vector<Case> left_out_cases(const ReportRequest& request);

/// Bodies in a cubic lattice at rest on nothing, turned at random: neighbours overlap a little, or are far
/// apart.
SceneDescription lattice(std::size_t count, const ShapeDescription& shape, double spacing, bool turned);

}  // namespace scree
