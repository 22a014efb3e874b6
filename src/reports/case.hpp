#pragma once

#include <algorithm>
#include <functional>
#include <string>

#include <scree/reports/report.hpp>

namespace scree {

/// Something that is still to be measured.
struct Case {
    std::string name;           ///< for the progress
    std::function<void()> run;  ///< measures it and puts it into its table
};

/// Whether the request wants the problem, axis or table of that name.
inline bool wanted(const ReportRequest& request, const std::string& name) {
    return request.only.empty() ||
           std::find(request.only.begin(), request.only.end(), name) != request.only.end();
}

}  // namespace scree
