#pragma once

#include <filesystem>
#include <string>

namespace scree {

/// A run's folder as one HTML file that needs nothing else: it plays the replay, and plots energy and
/// contacts over time beside it. `scripts`: where three.js is, as Debian's libjs-three has it. Throws
/// OutputError for what cannot be read.
std::string page_of_run(const std::filesystem::path& folder,
                        const std::filesystem::path& scripts = "/usr/share/javascript/three");

}  // namespace scree
