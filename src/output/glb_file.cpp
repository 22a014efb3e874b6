#include "glb_file.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace scree {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view start = "glTF\2\0\0\0";
constexpr std::size_t start_bytes = 8;
constexpr std::string_view json_kind = "JSON";
constexpr std::string_view binary_kind{"BIN\0", 4};

[[noreturn]] void refuse() {
    throw std::runtime_error("found no binary glTF file, expected one that scree has written");
}

/// Takes a number off the front.
std::uint32_t take_word(std::string_view& bytes) {
    std::uint32_t word = 0;
    if (bytes.size() < sizeof word) {
        refuse();
    }
    std::memcpy(&word, bytes.data(), sizeof word);
    bytes.remove_prefix(sizeof word);
    return word;
}

/// Takes a chunk of a kind off the front.
std::string_view take_chunk(std::string_view kind, std::string_view& bytes) {
    const std::size_t size = take_word(bytes);
    if (!bytes.starts_with(kind) || bytes.size() - kind.size() < size) {
        refuse();
    }
    const std::string_view chunk = bytes.substr(kind.size(), size);
    bytes.remove_prefix(kind.size() + size);
    return chunk;
}

void append_word(std::size_t word, std::string& bytes) {
    const auto number = static_cast<std::uint32_t>(word);
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    bytes.append(raw, sizeof number);
}

void append_chunk(std::string_view kind, std::string chunk, char padding, std::string& bytes) {
    chunk.resize((chunk.size() + 3) / 4 * 4, padding);
    append_word(chunk.size(), bytes);
    bytes.append(kind).append(chunk);
}

std::size_t components(const std::string& type) {
    return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
}

}  // namespace

GlbFile::GlbFile(std::string_view bytes) {
    if (!bytes.starts_with(std::string_view(start.data(), start_bytes))) {
        refuse();
    }
    bytes.remove_prefix(start_bytes);
    take_word(bytes);
    json = Json::parse(take_chunk(json_kind, bytes), nullptr, false);
    if (!json.is_object()) {
        refuse();
    }
    if (!bytes.empty()) {
        binary = take_chunk(binary_kind, bytes);
    }
}

std::string GlbFile::bytes() const {
    std::string chunks;
    append_chunk(json_kind, json.dump(-1, ' ', false, Json::error_handler_t::replace), ' ', chunks);
    append_chunk(binary_kind, binary, '\0', chunks);
    std::string whole(start.data(), start_bytes);
    append_word(start_bytes + sizeof(std::uint32_t) + chunks.size(), whole);
    return whole + chunks;
}

std::vector<float> GlbFile::numbers(std::size_t accessor) const {
    try {
        const Json& entry = json.at("accessors").at(accessor);
        const Json& view = json.at("bufferViews").at(entry.at("bufferView").get<std::size_t>());
        const auto begin =
            view.value("byteOffset", std::size_t{0}) + entry.value("byteOffset", std::size_t{0});
        const auto count = entry.at("count").get<std::size_t>() * components(entry.at("type"));
        if (begin > binary.size() || count > (binary.size() - begin) / sizeof(float)) {
            refuse();
        }
        std::vector<float> numbers(count);
        std::memcpy(numbers.data(), binary.data() + begin, count * sizeof(float));
        return numbers;
    } catch (const Json::exception&) {
        refuse();
    }
}

}  // namespace scree
