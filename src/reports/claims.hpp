#pragma once

#include <filesystem>

#include "case.hpp"
#include "table.hpp"

namespace scree {

// Single figures that are claimed of scree, each measured: claims.csv.

Table claims_table(const std::filesystem::path& folder);
std::vector<Case> claim_cases(const ReportRequest& request);

}  // namespace scree
