#include "body_names.hpp"

#include <unordered_set>

#include <scree/scenes/scene_error.hpp>

#include "json_text.hpp"

namespace scree {

std::vector<std::string> body_names(const SceneDescription& scene) {
    std::vector<std::string> names;
    std::unordered_set<std::string> taken;
    std::map<std::string, std::size_t> numbers;
    const auto add = [&](const std::string& name, const std::string& place) {
        if (!taken.insert(name).second) {
            throw SceneError(place, "the name " + in_quotes(name) + " again", "a name of its own");
        }
        names.push_back(name);
    };
    const auto numbered = [&](const std::string& shape) {
        return shape + "." + std::to_string(numbers[shape]++);
    };
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyDescription& body = scene.bodies[i];
        add(body.name.empty() ? numbered(body.shape) : body.name, "bodies." + std::to_string(i));
    }
    for (std::size_t i = 0; i < scene.fill.size(); ++i) {
        for (std::size_t k = 0; k < scene.fill[i].count; ++k) {
            add(numbered(scene.fill[i].shape), "fill." + std::to_string(i));
        }
    }
    return names;
}

}  // namespace scree
