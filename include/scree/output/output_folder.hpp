#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace scree {

/// Something of a run's folder could not be written, or read back. The message is one line: file, what was
/// found, what was expected.
class OutputError : public std::runtime_error {
  public:
    /// "FILE: found FOUND, expected EXPECTED".
    OutputError(const std::filesystem::path& file, const std::string& found,
                const std::string& expected = "to write it");
    /// `why` says what was found and what was expected.
    static OutputError unreadable(const std::filesystem::path& file, const std::string& why);

  private:
    explicit OutputError(const std::string& message) : std::runtime_error(message) {}
};

/// The folder that a run writes to.
class OutputFolder {
  public:
    /// What becomes of what is there.
    enum class Contents {
        fresh,  ///< the folder is made, and what an earlier run left is cleared away
        kept,   ///< the folder of a run that goes on
    };
    /// Throws OutputError.
    explicit OutputFolder(std::filesystem::path folder, Contents contents = Contents::fresh);

    /// Where a file of that name is.
    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }
    /// The folder.
    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

  private:
    void clear() const;

    std::filesystem::path folder_;
};

/// Writes a whole file under a temporary name, syncs it, then renames it: never half a file. Throws
/// OutputError.
void write_whole(const std::filesystem::path& file, std::string_view bytes);

}  // namespace scree
