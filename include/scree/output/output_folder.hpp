#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace scree {

/// Something could not be written. The message is one line: file, what was found, what was expected.
class OutputError : public std::runtime_error {
  public:
    OutputError(const std::filesystem::path& file, const std::string& found);
};

/// The folder that a run writes to. Making it makes the folder, and clears away what an earlier run left.
class OutputFolder {
  public:
    /// Throws OutputError.
    explicit OutputFolder(std::filesystem::path folder);

    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

  private:
    std::filesystem::path folder_;
};

/// Writes a whole file under a temporary name, then renames it: never half a file. Throws OutputError.
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace scree
