#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <scree/output/appended_file.hpp>

namespace scree {

/// Appends the shortest decimal that reads back as exactly this double.
void append_number(std::string& text, double value);

/// A comma-separated table on disk. Numbers read back exactly; words are quoted where they must be.
class CsvFile {
  public:
    /// `kept`: goes on with one that has the header, after that many bytes. Throws OutputError, as all that
    /// writes does.
    CsvFile(const std::filesystem::path& file, std::string_view header,
            std::optional<std::uint64_t> kept = std::nullopt);

    /// The next entry of the row.
    CsvFile& add(double value);
    /// The next entry of the row, quoted where it must be.
    CsvFile& add(std::string_view word);
    /// Ends the row at hand.
    void end_row();
    /// Hands all complete rows to the system.
    void flush();

    /// The file itself, to sync and to close.
    [[nodiscard]] AppendedFile& file() { return file_; }

  private:
    void separate();

    AppendedFile file_;
    std::string row_, rows_;
};

}  // namespace scree
