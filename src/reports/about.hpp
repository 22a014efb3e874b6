#pragma once

#include <filesystem>
#include <string>

#include "table.hpp"

namespace scree {

/// What a report was made by: processor, compiler, versions, commit, and how much was measured. Names no
/// machine and no path.
std::vector<Row> about_report(bool quick);

/// Makes the folder if need be, and throws away tables that something else has made. Throws OutputError.
void open_folder(const std::filesystem::path& folder, const std::vector<Row>& about);

}  // namespace scree
