#include <charconv>

#include <scree/scenes/scene_error.hpp>

#include "json_text.hpp"

namespace scree {

namespace {

Json parse_value(const std::string& text, const std::string& place) {
    if (!Json::accept(text)) {
        return text;
    }
    return parse_json(text, place, false);
}

std::size_t list_index(const Json& list, const std::string& part, const std::string& place) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    if (error != std::errc() || end != part.data() + part.size() || index >= list.size()) {
        throw SceneError(place, in_quotes(part),
                         list.empty() ? "nothing, for the list is empty"
                                      : "a number from 0 to " + std::to_string(list.size() - 1));
    }
    return index;
}

/// The member of `parent` that a part of a dotted path names.
Json& member(Json& parent, const std::string& part, const std::string& place) {
    if (parent.is_array()) {
        return parent[list_index(parent, part, place)];
    }
    if (parent.is_null()) {
        parent = Json::object();
    }
    if (!parent.is_object()) {
        throw SceneError(place, shown(parent), "an object or a list that has " + in_quotes(part));
    }
    return parent[part];
}

}  // namespace

void apply_setting(Json& scene, const std::string& setting) {
    const std::size_t equals = setting.find('=');
    const std::string place = "--set " + shown(Json(setting));
    if (equals == std::string::npos || equals == 0) {
        throw SceneError(place, "no key and value", "KEY=VALUE");
    }
    Json* target = &scene;
    std::size_t begin = 0;
    while (begin <= equals) {
        const std::size_t end = std::min(setting.find('.', begin), equals);
        if (end == begin) {
            throw SceneError(place, "an empty part of the path", "names between the dots");
        }
        target = &member(*target, setting.substr(begin, end - begin), place);
        begin = end + 1;
    }
    *target = parse_value(setting.substr(equals + 1), place);
}

}  // namespace scree
