#pragma once

#include <filesystem>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// A number as a table has it: short, and exact to six digits; empty when it is not finite.
std::string cell(double value);
/// The number in a cell; NaN when there is none.
double number_in(const std::string& cell);

/// The pieces of a text, one after the other.
std::string together(std::initializer_list<std::string_view> pieces);

using Row = std::vector<std::string>;

/// One line of a comma-separated table, without its end; quoted where it must be.
std::string csv_line(const Row& row);
/// The whole table in a text, header included; a last line without an end is dropped.
std::vector<Row> csv_rows(const std::string& text);

/// A comma-separated table on disk that grows row by row, each of them written at once. What a file of that
/// name and header already has is kept.
class Table {
  public:
    /// The key columns say which row it is. Throws OutputError, as all that writes does.
    Table(std::filesystem::path file, Row columns, const Row& keys);

    /// Whether there is a row of these keys, in the order of the key columns.
    [[nodiscard]] bool has(const Row& keys) const { return found_.contains(csv_line(keys)); }
    /// Adds a row, written to disk before this returns.
    void add(const Row& row);

    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    [[nodiscard]] const Row& columns() const { return columns_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// The place of a column that there is.
    [[nodiscard]] std::size_t column(const std::string& name) const;
    [[nodiscard]] const std::string& at(const Row& row, const std::string& name) const {
        return row[column(name)];
    }
    [[nodiscard]] double number(const Row& row, const std::string& name) const {
        return number_in(at(row, name));
    }

  private:
    [[nodiscard]] std::string key(const Row& row) const;
    void read();
    void write() const;

    std::filesystem::path file_;
    Row columns_;
    std::vector<std::size_t> keys_;
    std::vector<Row> rows_;
    std::set<std::string> found_;
};

}  // namespace scree
