#include <scree/scenes/read_scene.hpp>

#include <scree/scenes/find_scene.hpp>

#include "readers.hpp"
#include "values.hpp"

namespace scree {

namespace {

/// Reads an object whose keys are names of the user's.
template <class T>
void read_named(const Node& node, std::map<std::string, T>& named, void (*read)(const Node&, T&)) {
    if (!node.value().is_object()) {
        node.refuse("an object");
    }
    for (const auto& [key, value] : node.value().items()) {
        const Node entry(node, key);
        check_name(entry, key);
        read(entry, named[key]);
    }
}

using S = SceneDescription;
constexpr Field<S> scene_fields[] = {
    {"gravity", into<&S::gravity, vector>},
    {"materials", [](const Node& node, S& scene) { read_named(node, scene.materials, read_material); },
     required},
    {"pairs", [](const Node& node, S& scene) { scene.pairs = list(node, read_pair); }},
    {"shapes", [](const Node& node, S& scene) { read_named(node, scene.shapes, read_shape); }, required},
    {"bodies", [](const Node& node, S& scene) { scene.bodies = list(node, read_body); }},
    {"fill", [](const Node& node, S& scene) { scene.fill = list(node, read_fill); }},
    {"law", [](const Node& node, S& scene) { read_law(node, scene.law); }},
    {"stepping", [](const Node& node, S& scene) { read_stepping(node, scene.stepping); }},
    {"end_time", into<&S::end_time, positive>, required},
    {"output", [](const Node& node, S& scene) { read_output(node, scene.output); }},
};

}  // namespace

SceneDescription parse_scene(std::string_view text, const std::filesystem::path& file,
                             const std::vector<std::string>& settings) {
    Json json = parse_json(text, file.string());
    for (const std::string& setting : settings) {
        apply_setting(json, setting);
    }
    SceneDescription scene;
    scene.file = file;
    scene.name = scene_name(file);
    scene.text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    try {
        read_fields(Node(json), scene_fields, scene);
        check_in_this_build(json);
    } catch (const SceneError& error) {
        throw error.in_file(file.string());
    }
    check_scene(scene);
    return scene;
}

SceneDescription read_scene(const std::filesystem::path& file, const std::vector<std::string>& settings) {
    return parse_scene(read_text(file), file, settings);
}

}  // namespace scree
