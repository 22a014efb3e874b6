#include <scree/output/csv_file.hpp>

#include <charconv>

namespace scree {

namespace {

constexpr std::size_t block = 1 << 16;  // bytes, kept back between writes

}  // namespace

void append_number(std::string& text, double value) {
    char digits[32];  // the longest double takes 24
    const auto [end, error] = std::to_chars(std::begin(digits), std::end(digits), value);
    text.append(digits, end);
}

CsvFile::CsvFile(const std::filesystem::path& file, std::string_view header,
                 std::optional<std::uint64_t> kept)
    : file_(kept ? AppendedFile(file, *kept) : AppendedFile(file)) {
    if (!kept) {
        rows_ = header;
        rows_ += '\n';
        flush();
    }
}

CsvFile& CsvFile::add(double value) {
    separate();
    append_number(row_, value);
    return *this;
}

CsvFile& CsvFile::add(std::string_view word) {
    separate();
    if (word.find_first_of(",\"\r\n") == std::string_view::npos) {
        row_ += word;
        return *this;
    }
    row_ += '"';
    for (const char c : word) {
        row_.append(c == '"' ? 2 : 1, c);
    }
    row_ += '"';
    return *this;
}

void CsvFile::separate() {
    if (!row_.empty()) {
        row_ += ',';
    }
}

void CsvFile::end_row() {
    rows_ += row_;
    rows_ += '\n';
    row_.clear();
    if (rows_.size() > block) {
        flush();
    }
}

void CsvFile::flush() {
    file_.append(rows_);
    rows_.clear();
}

}  // namespace scree
