#include "ply_header.hpp"

#include <sstream>
#include <string_view>
#include <utility>

#include <scree/mesh_io/load_mesh.hpp>

#include "shown.hpp"

namespace scree {

namespace {

/// Bytes of a type; 0 for one that is unknown.
std::uint64_t size_of(std::string_view type) {
    constexpr std::pair<std::string_view, std::uint64_t> sizes[] = {
        {"char", 1},  {"uchar", 1},  {"short", 2},   {"ushort", 2}, {"int", 4},   {"uint", 4},
        {"float", 4}, {"double", 8}, {"int8", 1},    {"uint8", 1},  {"int16", 2}, {"uint16", 2},
        {"int32", 4}, {"uint32", 4}, {"float32", 4}, {"float64", 8}};
    for (const auto& [name, size] : sizes) {
        if (name == type) {
            return size;
        }
    }
    return 0;
}

PlyElement element(std::istringstream& words, const std::string& line, const std::filesystem::path& file) {
    PlyElement read;
    double count = 0;
    const std::uint64_t bytes = std::filesystem::file_size(file);
    if (words >> read.name >> count && !(count >= 0 && count <= static_cast<double>(bytes))) {
        throw MeshError(file.string() + ": found a header that announces " + shown(line.substr(8)) +
                        ", expected no more than the file's " + std::to_string(bytes) + " bytes hold");
    }
    read.count = static_cast<std::uint64_t>(count);
    return read;
}

PlyProperty property(std::istringstream& words) {
    std::string type;
    words >> type;
    if (type != "list") {
        return {size_of(type), 0};
    }
    std::string length;
    words >> length >> type;
    return {size_of(type), size_of(length)};
}

PlyFormat format(const std::string& word, const std::filesystem::path& file) {
    constexpr std::pair<std::string_view, PlyFormat> formats[] = {
        {"ascii", PlyFormat::ascii},
        {"binary_little_endian", PlyFormat::little_endian},
        {"binary_big_endian", PlyFormat::big_endian}};
    for (const auto& [name, format] : formats) {
        if (name == word) {
            return format;
        }
    }
    throw MeshError(file.string() + ": found the format \"" + shown(word) +
                    "\", expected ascii, binary_little_endian or binary_big_endian");
}

}  // namespace

bool next_line(std::istream& stream, std::string& line) {
    constexpr std::size_t longest = 1000;
    line.clear();
    char c = 0;
    while (line.size() < longest && stream.get(c) && c != '\n') {
        line.push_back(c);
    }
    return static_cast<bool>(stream);
}

PlyHeader read_ply_header(std::istream& stream, const std::filesystem::path& file) {
    PlyHeader header;
    std::string line;
    while (next_line(stream, line) && !line.starts_with("end_header")) {
        std::istringstream words(line);
        std::string keyword;
        words >> keyword;
        if (keyword == "format") {
            words >> keyword;
            header.format = format(keyword, file);
        } else if (keyword == "element") {
            header.elements.push_back(element(words, line, file));
        } else if (keyword == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(property(words));
        }
    }
    return header;
}

}  // namespace scree
