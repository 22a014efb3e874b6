#include <scree/scenes/scene_error.hpp>

#include "readers.hpp"

namespace scree {

namespace {

/// A value that the scene file may have, and nothing here can do. Stars stand for any key or number; a row
/// goes when its feature comes.
struct Absent {
    std::string_view path;
    std::string_view value;  ///< a word, or one of the kinds below
};
constexpr std::string_view any = "*";
constexpr std::string_view several = "[]";
constexpr std::string_view on = "true";
constexpr std::string_view above_zero = ">0";

constexpr Absent absent[] = {
    {"materials.*.torsion", "patch"},
    {"pairs.*.torsion", "patch"},
    {"shapes.*.parts", "decompose"},
    {"shapes.*.parts", several},
    {"law.normal", "energy"},
    {"output.replay", on},
    {"output.vtk", on},
    {"output.checkpoint_every", above_zero},
};

bool matches(const Json& value, std::string_view wanted) {
    if (wanted == any) {
        return true;
    }
    switch (value.type()) {
        case Json::value_t::array:
            return wanted == several;
        case Json::value_t::boolean:
            return value.get<bool>() && wanted == on;
        case Json::value_t::string:
            return value == wanted;
        default:
            return value.is_number() && value > 0 && wanted == above_zero;
    }
}

void refuse_at(const Node& node, std::string_view path, std::string_view wanted) {
    if (path.empty()) {
        if (matches(node.value(), wanted)) {
            node.refuse(shown(node.value()) + ", which is not in this build", "a scene without it");
        }
        return;
    }
    const std::size_t dot = std::min(path.find('.'), path.size());
    const std::string_view key = path.substr(0, dot);
    const std::string_view rest = path.substr(std::min(dot + 1, path.size()));
    const Json& value = node.value();
    if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            refuse_at(Node(node, i), rest, wanted);
        }
    } else if (key == "*") {
        for (const auto& [name, member] : value.items()) {
            refuse_at(Node(node, name), rest, wanted);
        }
    } else if (value.contains(key)) {
        refuse_at(Node(node, key), rest, wanted);
    }
}

}  // namespace

void check_in_this_build(const Json& scene) {
    for (const Absent& row : absent) {
        refuse_at(Node(scene), row.path, row.value);
    }
}

}  // namespace scree
