#pragma once

#include <string>
#include <vector>

#include <scree/scenes/read_scene.hpp>

namespace scree::test {

/// A scene without meshes: a box on a floor, and a ball.
inline const std::string small_scene = R"({
    "materials": {"rock": {"density": 2600, "youngs_modulus": 1e9, "friction": 0.5}},
    "shapes": {
        "floor": {"half_space": {"normal": [0, 0, 1]}},
        "crate": {"box": [0.1, 0.1, 0.1]},
        "ball": {"sphere": 0.05}
    },
    "bodies": [
        {"name": "ground", "shape": "floor", "material": "rock", "motion": "fixed"},
        {"name": "block", "shape": "crate", "material": "rock", "position": [0, 0, 0.05]},
        {"shape": "ball", "material": "rock", "position": [1, 0, 0.06]}
    ],
    "end_time": 0.1
})";

/// The small scene with some KEY=VALUE changes.
inline SceneDescription small_scene_with(const std::vector<std::string>& settings) {
    return parse_scene(small_scene, "folder/small.json", settings);
}

}  // namespace scree::test
