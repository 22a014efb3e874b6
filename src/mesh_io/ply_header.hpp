#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <vector>

namespace scree {

struct PlyProperty {
    std::uint64_t size = 0;    ///< [bytes], of the value or of an entry of the list
    std::uint64_t length = 0;  ///< [bytes], of the number that says how long the list is; 0: no list
};

/// So many of them follow one another, each with these properties.
struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    [[nodiscard]] bool has_list() const {
        return std::any_of(properties.begin(), properties.end(), [](const auto& p) { return p.length > 0; });
    }
    [[nodiscard]] std::uint64_t size() const {
        std::uint64_t sum = 0;
        for (const PlyProperty& property : properties) {
            sum += property.size;
        }
        return sum;
    }
};

enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
};

/// Reads on after the file's first line, up to the data. Throws MeshError for a format that is none, and for
/// a header that announces more elements than the file has bytes.
PlyHeader read_ply_header(std::istream& stream, const std::filesystem::path& file);

/// The next line, cut short: what follows a header may have no ends of lines.
bool next_line(std::istream& stream, std::string& line);

}  // namespace scree
