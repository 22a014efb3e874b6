#include "collada_asset.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include <scree/mesh_io/load_mesh.hpp>

#include "shown.hpp"

namespace scree {

namespace {

constexpr std::size_t longest = 1 << 16;  // bytes; the asset comes first
constexpr std::string_view blanks = " \t\r\n";

/// What is between two marks, the first found in `text`; empty when they are not both there.
std::string_view between(std::string_view text, std::string_view from, std::string_view to) {
    const std::size_t begin = text.find(from);
    if (begin == std::string_view::npos) {
        return {};
    }
    text.remove_prefix(begin + from.size());
    return text.substr(0, text.find(to));
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(blanks);
    return begin == std::string_view::npos ? std::string_view()
                                           : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// The value of the attribute in an element's text.
std::string_view attribute(std::string_view element, std::string_view name) {
    const std::size_t at = element.find(name);
    const std::size_t quote = at == std::string_view::npos ? at : element.find_first_of("\"'", at);
    return quote == std::string_view::npos
               ? std::string_view()
               : trimmed(between(element.substr(quote), element.substr(quote, 1), element.substr(quote, 1)));
}

bool is_length(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value) && value > 0;
}

}  // namespace

void check_collada_asset(const std::filesystem::path& file) {
    std::string text(longest, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    const std::string_view asset = between(text, "<asset", "</asset>");
    const std::string_view unit = between(asset, "<unit", ">");
    const std::string_view metres = attribute(unit, "meter");
    if (unit.find("meter") != std::string_view::npos && !is_length(metres)) {
        throw MeshError(file.string() + ": found the unit \"" + shown(metres) +
                        "\", expected its length in metres, above 0");
    }
    const std::string_view axis = trimmed(between(asset, "<up_axis>", "<"));
    if (!axis.empty() && axis != "X_UP" && axis != "Y_UP" && axis != "Z_UP") {
        throw MeshError(file.string() + ": found the upward axis \"" + shown(axis) +
                        "\", expected X_UP, Y_UP or Z_UP");
    }
}

}  // namespace scree
