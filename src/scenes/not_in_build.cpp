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
constexpr std::string_view on = "true";

const std::vector<Absent> absent = {
#ifndef SCREE_HAS_VTK
    {"output.vtk", on},
#endif
};

bool matches(const Json& value, std::string_view wanted) {
    if (wanted == any) {
        return true;
    }
    switch (value.type()) {
        case Json::value_t::boolean:
            return value.get<bool>() && wanted == on;
        case Json::value_t::string:
            return value == wanted;
        default:
            return false;
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
