#include "page.hpp"

namespace scree {

namespace {

std::string replaced(const std::string& text, const std::vector<std::pair<char, const char*>>& marks) {
    std::string result;
    for (const char c : text) {
        const char* other = nullptr;
        for (const auto& [mark, replacement] : marks) {
            other = c == mark ? replacement : other;
        }
        other == nullptr ? result += c : result += other;
    }
    return result;
}

std::string escaped(const std::string& text) {
    return replaced(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
}

std::string markdown_row(const Row& row) {
    std::string line = "|";
    for (const std::string& each : row) {
        line.append(" ").append(replaced(each, {{'|', "\\|"}, {'\n', " "}})).append(" |");
    }
    line += "\n";
    return line;
}

std::string markdown_table(const std::vector<Row>& rows) {
    std::string text;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        text += markdown_row(rows[i]);
        if (i == 0) {
            text += "|";
            for (std::size_t c = 0; c < rows[i].size(); ++c) {
                text += "---|";
            }
            text += "\n";
        }
    }
    return text;
}

/// Cells that begin with one of the words of a verdict are coloured by it.
std::string html_cell(const std::string& tag, const std::string& text) {
    const std::string word = text.substr(0, text.find(' '));
    const bool verdict = word == "stable" || word == "inaccurate" || word == "failed" || word == "stopped";
    const std::string mark = verdict ? together({" class=\"", word, "\""}) : "";
    return together({"<", tag, mark, ">", escaped(text), "</", tag, ">"});
}

std::string html_table(const std::vector<Row>& rows) {
    std::string text = "<table>\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        text += "<tr>";
        for (const std::string& each : rows[i]) {
            text += html_cell(i == 0 ? "th" : "td", each);
        }
        text += "</tr>\n";
    }
    text += "</table>\n";
    return text;
}

constexpr const char* style =
    "body{font:15px/1.5 sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#222}\n"
    "table{border-collapse:collapse;font-size:13px;margin:1em 0;display:block;overflow-x:auto}\n"
    "th,td{border:1px solid #ccc;padding:.15em .5em;text-align:left;vertical-align:top}\n"
    "th{background:#f2f2f2}img{max-width:100%}figcaption{color:#555}\n"
    ".stable{background:#d9f0d9}.inaccurate{background:#fbf0c9}.failed{background:#f6d5d5}"
    ".stopped{background:#e3e3e3}\n";

}  // namespace

Page& Page::heading(int level, const std::string& text) {
    parts_.push_back({Kind::heading, level, text, "", {}});
    return *this;
}

Page& Page::text(const std::string& paragraph) {
    parts_.push_back({Kind::text, 0, paragraph, "", {}});
    return *this;
}

Page& Page::table(const std::vector<Row>& rows) {
    parts_.push_back({Kind::table, 0, "", "", rows});
    return *this;
}

Page& Page::picture(const std::string& file, const std::string& caption) {
    parts_.push_back({Kind::picture, 0, caption, file, {}});
    return *this;
}

std::string Page::markdown() const {
    std::string all;
    for (const Part& part : parts_) {
        all += all.empty() ? "" : "\n";
        switch (part.kind) {
            case Kind::heading:
                all +=
                    together({std::string(static_cast<std::size_t>(part.level), '#'), " ", part.text, "\n"});
                break;
            case Kind::text:
                all += together({part.text, "\n"});
                break;
            case Kind::table:
                all += markdown_table(part.rows);
                break;
            case Kind::picture:
                all += together({"![", part.text, "](", part.file, ")\n"});
                break;
        }
    }
    return all;
}

std::string Page::html(const std::string& title) const {
    std::string all = together({"<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>",
                                escaped(title), "</title>\n<style>\n", style, "</style></head><body>\n"});
    for (const Part& part : parts_) {
        const std::string tag = together({"h", std::to_string(part.level)});
        switch (part.kind) {
            case Kind::heading:
                all += together({"<", tag, ">", escaped(part.text), "</", tag, ">\n"});
                break;
            case Kind::text:
                all += together({"<p>", escaped(part.text), "</p>\n"});
                break;
            case Kind::table:
                all += html_table(part.rows);
                break;
            case Kind::picture:
                all += together({"<figure><img src=\"", escaped(part.file), "\" alt=\"", escaped(part.text),
                                 "\"><figcaption>", escaped(part.text), "</figcaption></figure>\n"});
                break;
        }
    }
    all += "</body></html>\n";
    return all;
}

}  // namespace scree
