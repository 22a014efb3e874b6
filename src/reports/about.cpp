#include "about.hpp"

#include <fstream>
#include <sstream>
#include <thread>

#include <scree/output/output_folder.hpp>
#include <scree/version.hpp>

#include "build_facts.hpp"

namespace scree {

namespace {

std::string processor() {
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);) {
        const std::size_t mark = line.find(": ");
        if (line.starts_with("model name") && mark != std::string::npos) {
            return line.substr(mark + 2);
        }
    }
    return "unknown";
}

std::string text_of(const std::vector<Row>& rows) {
    std::string text;
    for (const Row& row : rows) {
        text += csv_line(row) + "\n";
    }
    return text;
}

std::string text_in(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder)) {
        throw OutputError(folder, error ? error.message() : "something that is no folder");
    }
}

}  // namespace

std::vector<Row> about_report(bool quick) {
    return {{"what", "value"},
            {"scree", version},
            {"commit", build_commit},
            {"extent", quick ? "quick" : "full"},
            {"processor", processor()},
            {"threads of it", std::to_string(std::thread::hardware_concurrency())},
            {"compiler", build_compiler},
            {"build", build_options},
            {"Bullet", bullet_version},
            {"Eigen", eigen_version},
            {"Qhull", qhull_version},
            {"assimp", assimp_version}};
}

void open_folder(const std::filesystem::path& folder, const std::vector<Row>& about) {
    make_folder(folder);
    const std::filesystem::path file = folder / "about.csv";
    if (text_in(file) == text_of(about)) {
        return;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".csv") {
            std::filesystem::remove(entry.path());
        }
    }
    write_whole(file, text_of(about));
}

}  // namespace scree
