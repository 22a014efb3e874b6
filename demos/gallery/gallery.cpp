// The scenes that come with scree, measured against literature and closed forms: gallery [FOLDER [SCENE...]].
// Writes results.csv and results.md to the folder, in which other scenes keep the results they have. gallery
// --list: the scenes and the moments of their pictures.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <sstream>

#include "scenes.hpp"

namespace {

using scree::gallery::Row;
using scree::gallery::Rows;

std::string text(double value) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.4g", value);
    return digits;
}

std::string bounds(const Row& row) {
    if (row.high == scree::gallery::infinity) {
        return "at least " + text(row.low);
    }
    return row.low == 0 ? "at most " + text(row.high) : text(row.low) + " to " + text(row.high);
}

using Lines = std::vector<std::string>;

// A line of results.csv and one of results.md.
std::string table_line(const Row& row) {
    std::ostringstream line;
    line << row.scene << ",\"" << row.what << "\"," << row.measured << ',' << row.low << ',' << row.high
         << ',' << (row.holds() ? "yes" : "no") << ",\"" << row.source << '"';
    return line.str();
}
std::string page_line(const Row& row) {
    return "| " + row.scene + " | " + row.what + " | " + text(row.measured) + " | " + bounds(row) +
           (row.holds() ? "" : ", **not so**") + " | " + row.source + " |";
}

Lines lines_of(const std::filesystem::path& file) {
    Lines lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

// Replaces a file's lines of the scenes that were measured and keeps those of the others, which begin with
// `before`, the scene and `after`.
void renew(const std::filesystem::path& file, const Lines& head, const std::string& before,
           const std::string& after, const Rows& rows, std::string (*line_of)(const Row&)) {
    Lines lines = head;
    const Lines old = lines_of(file);
    for (const scree::gallery::Scene& scene : scree::gallery::scenes()) {
        Lines fresh;
        for (const Row& row : rows) {
            if (row.scene == scene.name) {
                fresh.push_back(line_of(row));
            }
        }
        const std::string start = before + scene.name + after;
        if (fresh.empty()) {
            std::copy_if(old.begin(), old.end(), std::back_inserter(fresh),
                         [&](const std::string& line) { return line.starts_with(start); });
        }
        lines.insert(lines.end(), fresh.begin(), fresh.end());
    }
    std::ofstream stream(file);
    for (const std::string& line : lines) {
        stream << line << '\n';
    }
    if (!stream.flush()) {
        throw std::runtime_error("cannot write " + file.string());
    }
}

void write(const Rows& rows, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    renew(folder / "results.csv", {"scene,what,measured,low,high,holds,source"}, "", ",", rows, table_line);
    renew(folder / "results.md", {"| scene | what | measured | expected | by |", "|---|---|---|---|---|"},
          "| ", " | ", rows, page_line);
}

void print(const Rows& rows, double seconds) {
    for (const Row& row : rows) {
        std::printf("%-5s %-16s %-62s %10s  %-22s %s\n", row.holds() ? "holds" : "NOT", row.scene.c_str(),
                    row.what.c_str(), text(row.measured).c_str(), bounds(row).c_str(), row.source.c_str());
    }
    std::printf("      (%.0f s)\n", seconds);
    std::fflush(stdout);
}

void list() {
    for (const scree::gallery::Scene& scene : scree::gallery::scenes()) {
        std::printf("%s %g\n", scene.name, scene.picture);
    }
}

bool is_wanted(const scree::gallery::Scene& scene, const std::vector<std::string>& wanted) {
    return scene.rows != nullptr &&
           (wanted.empty() || std::find(wanted.begin(), wanted.end(), scene.name) != wanted.end());
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc > 1 && std::string(argv[1]) == "--list") {
        list();
        return EXIT_SUCCESS;
    }
    const std::filesystem::path folder =
        argc > 1 ? argv[1] : std::filesystem::path(SCREE_SOURCE_DIR) / "demos/gallery";
    const std::vector<std::string> wanted(argv + std::min(argc, 2), argv + argc);
    Rows all;
    for (const scree::gallery::Scene& scene : scree::gallery::scenes()) {
        if (!is_wanted(scene, wanted)) {
            continue;
        }
        const auto start = std::chrono::steady_clock::now();
        const Rows rows = scene.rows();
        print(rows, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        all.insert(all.end(), rows.begin(), rows.end());
    }
    write(all, folder);
    const bool good = std::all_of(all.begin(), all.end(), [](const Row& row) { return row.holds(); });
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const std::exception& error) {
    std::fprintf(stderr, "gallery: %s\n", error.what());
    return 2;
}
