#include "table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <scree/output/output_folder.hpp>

namespace scree {

namespace {

std::string quoted(const std::string& word) {
    if (word.find_first_of(",\"\r\n") == std::string::npos) {
        return word;
    }
    std::string text = "\"";
    for (const char c : word) {
        text.append(c == '"' ? 2 : 1, c);
    }
    text += '"';
    return text;
}

std::string text_in(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

}  // namespace

std::string cell(double value) {
    if (!std::isfinite(value)) {
        return "";
    }
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    return digits;
}

std::string together(std::initializer_list<std::string_view> pieces) {
    std::string text;
    for (const std::string_view piece : pieces) {
        text += piece;
    }
    return text;
}

double number_in(const std::string& cell) {
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const bool whole = !cell.empty() && error == std::errc() && end == cell.data() + cell.size();
    return whole ? value : std::numeric_limits<double>::quiet_NaN();
}

std::string csv_line(const Row& row) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
        line.append(i == 0 ? "" : ",").append(quoted(row[i]));
    }
    return line;
}

std::vector<Row> csv_rows(const std::string& text) {
    std::vector<Row> rows;
    Row row(1);
    bool inside = false;  // of quotes
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' && inside && i + 1 < text.size() && text[i + 1] == '"') {
            row.back() += text[++i];
        } else if (c == '"') {
            inside = !inside;
        } else if (c == ',' && !inside) {
            row.emplace_back();
        } else if (c == '\n' && !inside) {
            rows.push_back(row);
            row.assign(1, "");
        } else {
            row.back() += c;
        }
    }
    return rows;
}

Table::Table(std::filesystem::path file, Row columns, const Row& keys)
    : file_(std::move(file)), columns_(std::move(columns)) {
    for (const std::string& name : keys) {
        keys_.push_back(column(name));
    }
    if (std::filesystem::exists(file_)) {
        read();
        write();  // so that half a row at the end of a run that was cut off is gone
    }
}

void Table::write() const {
    std::string text = csv_line(columns_).append("\n");
    for (const Row& row : rows_) {
        text.append(csv_line(row)).append("\n");
    }
    write_whole(file_, text);
}

void Table::read() {
    const std::vector<Row> all = csv_rows(text_in(file_));
    if (all.empty() || all.front() != columns_) {
        return;
    }
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (all[i].size() == columns_.size() && found_.insert(key(all[i])).second) {
            rows_.push_back(all[i]);
        }
    }
}

void Table::add(const Row& row) {
    if (row.size() != columns_.size()) {
        throw std::logic_error("a row of another table");
    }
    if (rows_.empty()) {
        write();
    }
    std::ofstream stream(file_, std::ios::binary | std::ios::app);
    stream << csv_line(row) << "\n" << std::flush;
    if (!stream) {
        throw OutputError(file_, "a table that cannot be written");
    }
    rows_.push_back(row);
    found_.insert(key(row));
}

std::size_t Table::column(const std::string& name) const {
    const auto place = std::find(columns_.begin(), columns_.end(), name);
    if (place == columns_.end()) {
        throw std::logic_error("no column " + name);
    }
    return static_cast<std::size_t>(place - columns_.begin());
}

std::string Table::key(const Row& row) const {
    Row keys;
    for (const std::size_t place : keys_) {
        keys.push_back(row[place]);
    }
    return csv_line(keys);
}

}  // namespace scree
