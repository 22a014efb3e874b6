#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace scree {

/// What a report is asked for.
struct ReportRequest {
    bool accuracy = false;          ///< error against run time, by problem and method
    bool stability = false;         ///< extreme cases, and the greatest stable steps
    bool cost = false;              ///< by stage, by size, by feature
    bool quick = false;             ///< fewer cases and shorter runs, within five minutes on two cores
    std::filesystem::path out;      ///< the folder to write to
    std::vector<std::string> only;  ///< problems, axes or tables by name; empty: all
};

/// Called before each case with what is done, out of how many, and what comes; returns whether to go on.
using ReportProgress = std::function<bool(std::size_t done, std::size_t all, const std::string& next)>;

/// Measures what is not yet in the tables of the folder, row by row, and writes the pages. Rows of another
/// build, machine or extent are thrown away first. Returns false when it was told to stop: what is measured
/// is kept, and the next call goes on from there. Throws OutputError, and SceneError for a name in `only`
/// that nothing has.
bool make_report(const ReportRequest& request, const ReportProgress& progress);

}  // namespace scree
