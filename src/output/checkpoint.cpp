#include <scree/output/checkpoint.hpp>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <charconv>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include <scree/output/output_folder.hpp>
#include <scree/version.hpp>

#include "depth_check.hpp"

namespace scree {

namespace {

using Json = nlohmann::json;

constexpr std::string_view title = "scree checkpoint ";
constexpr unsigned format = 1;
constexpr std::size_t longest_line = 80;
constexpr std::size_t deepest = 8;  // it needs three

Json json_of(const SavedState& state) {
    return {{"numbers", state.numbers}, {"counts", state.counts}};
}

SavedState state_of(const Json& json) {
    return {json.at("numbers").get<std::vector<double>>(),
            json.at("counts").get<std::vector<std::uint64_t>>()};
}

std::string hex(std::uint64_t value) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value));
    return digits;
}

std::string checksum(std::string_view bytes) {
    return hex(XXH3_64bits(bytes.data(), bytes.size()));
}

/// Takes a number and what ends it off the front of a line.
std::uint64_t take_number(std::string_view& line, int base, char after) {
    std::uint64_t value = 0;
    const char* last = line.data() + line.size();
    const auto [end, error] = std::from_chars(line.data(), last, value, base);
    if (error != std::errc() || end == last || *end != after) {
        throw CheckpointError("another first line", "that of a checkpoint");
    }
    line.remove_prefix(static_cast<std::size_t>(end - line.data()) + 1);
    return value;
}

/// The CBOR, when its size and checksum are those of the first line.
std::string_view checked_body(std::string_view bytes) {
    std::string_view line = bytes.substr(0, longest_line);
    if (!line.starts_with(title)) {
        throw CheckpointError("another file", "a checkpoint");
    }
    line = line.substr(0, line.find('\n') + 1);
    const std::size_t begin = line.size();
    line.remove_prefix(std::min(title.size(), line.size()));
    if (const std::uint64_t number = take_number(line, 10, ' '); number != format) {
        throw CheckpointError("format " + std::to_string(number), std::to_string(format));
    }
    const std::uint64_t size = take_number(line, 10, ' ');
    const std::uint64_t sum = take_number(line, 16, '\n');
    const std::string_view body = bytes.substr(begin);
    if (body.size() != size) {
        throw CheckpointError(std::to_string(body.size()) + " bytes",
                              std::to_string(size) + ": it is not whole");
    }
    if (checksum(body) != hex(sum)) {
        throw CheckpointError("another checksum", "that of its first line: it has been altered");
    }
    return body;
}

// What a file says it is of, for an error message: not too long, and nothing in it that is not to be read.
std::string readable(const std::string& text) {
    constexpr std::size_t longest = 40;
    const std::string quoted =
        Json(text.substr(0, longest)).dump(-1, ' ', true, Json::error_handler_t::replace);
    return quoted.substr(1, quoted.size() - 2);
}

Checkpoint checkpoint_of(const Json& json) {
    if (const auto other = json.at("scree").get<std::string>(); other != version) {
        throw CheckpointError("one of scree " + readable(other), std::string("one of scree ") + version);
    }
    Checkpoint checkpoint;
    json.at("scene").get_to(checkpoint.scene);
    json.at("scene_file").get_to(checkpoint.scene_file);
    for (const auto& [name, shape] : json.at("shapes").items()) {
        checkpoint.shapes[name] = state_of(shape);
    }
    json.at("files").get_to(checkpoint.files);
    json.at("wall").get_to(checkpoint.wall);
    json.at("writing").get_to(checkpoint.writing);
    checkpoint.state = state_of(json.at("state"));
    return checkpoint;
}

}  // namespace

std::string checkpoint_bytes(const Checkpoint& checkpoint) {
    Json json = {{"scree", version},
                 {"scene", checkpoint.scene},
                 {"scene_file", checkpoint.scene_file},
                 {"shapes", Json::object()},
                 {"files", checkpoint.files},
                 {"wall", checkpoint.wall},
                 {"writing", checkpoint.writing},
                 {"state", json_of(checkpoint.state)}};
    for (const auto& [name, shape] : checkpoint.shapes) {
        json["shapes"][name] = json_of(shape);
    }
    std::string body;
    Json::to_cbor(json, body);
    return sealed_checkpoint(body);
}

std::string sealed_checkpoint(std::string_view cbor) {
    std::string bytes = std::string(title) + std::to_string(format) + ' ' + std::to_string(cbor.size()) +
                        ' ' + checksum(cbor) + '\n';
    return bytes.append(cbor);
}

Checkpoint parse_checkpoint(std::string_view bytes) {
    const std::string_view body = checked_body(bytes);
    try {
        if (nests_deeper(body, deepest)) {
            throw CheckpointError("values nested deeper than " + std::to_string(deepest), "a checkpoint");
        }
        return checkpoint_of(Json::from_cbor(body.begin(), body.end()));
    } catch (const Json::exception&) {
        throw CheckpointError("other contents", "those of a checkpoint");
    }
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file)) {
        throw OutputError(file, "no checkpoint",
                          "one, as interrupted runs and those with \"checkpoint_every\" leave");
    }
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    try {
        return parse_checkpoint(bytes);
    } catch (const std::exception& error) {
        throw OutputError::unreadable(file, error.what());
    }
}

}  // namespace scree
