#pragma once

// What the demos that draw share: a table on disk, and its picture by gnuplot where that is installed.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

/// A CSV file with its header. Throws std::runtime_error when it cannot be written.
inline std::ofstream table(const std::filesystem::path& file, const std::string& header) {
    std::ofstream stream(file);
    if (!stream) {
        throw std::runtime_error("cannot write " + file.string());
    }
    stream.precision(6);
    stream << header << "\n";
    return stream;
}

/// Draws the tables in a folder by demos/<name>/<name>.gp as <name>.svg beside them, and says so.
inline void draw(const std::string& name, const std::filesystem::path& out) {
    const auto script = std::filesystem::path(SCREE_SOURCE_DIR) / "demos" / name / (name + ".gp");
    const auto picture = out / (name + ".svg");
    std::ostringstream command;
    command << "gnuplot -c " << script << ' ' << out << ' ' << picture;  // paths are written in quotes
    if (std::system("gnuplot --version >/dev/null 2>&1") != 0) {
        std::printf("no picture: gnuplot is not installed\n");
    } else if (std::system(command.str().c_str()) == 0) {
        std::printf("picture: %s\n", picture.c_str());
    }
}
