#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace scree {

/// Appends the shortest decimal that reads back as exactly this double.
void append_number(std::string& text, double value);

/// A comma-separated table on disk. Numbers read back exactly; words are quoted where they must be.
class CsvFile {
  public:
    /// Throws OutputError, as all that writes does.
    CsvFile(const std::filesystem::path& file, std::string_view header);

    CsvFile& add(double value);
    CsvFile& add(std::string_view word);
    void end_row();
    /// Hands all complete rows to the system.
    void flush();

  private:
    void separate();

    std::filesystem::path file_;
    std::ofstream stream_;
    std::string row_, rows_;
};

}  // namespace scree
