#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "table.hpp"

namespace scree {

/// A page of headings, text, tables and pictures, written once for browsers and once as Markdown.
class Page {
  public:
    Page& heading(int level, const std::string& text);
    Page& text(const std::string& paragraph);
    /// The first row is the header.
    Page& table(const std::vector<Row>& rows);
    /// A file beside the page.
    Page& picture(const std::string& file, const std::string& caption);

    [[nodiscard]] std::string markdown() const;
    [[nodiscard]] std::string html(const std::string& title) const;

  private:
    enum class Kind { heading, text, table, picture };
    struct Part {
        Kind kind = Kind::text;
        int level = 0;
        std::string text, file;
        std::vector<Row> rows;
    };

    std::vector<Part> parts_;
};

}  // namespace scree
