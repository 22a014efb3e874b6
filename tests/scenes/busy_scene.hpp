#pragma once

#include <string>
#include <vector>

#include <scree/scenes/read_scene.hpp>

namespace scree::test {

/// A scene in which most things happen at once: stones fall onto a shaken plate and one another, a crate
/// rides on a belt, a tower stands, a ball rolls. Several groups form, merge and part.
inline const std::string busy_scene = R"({
    "materials": {
        "rock": {"density": 2600, "youngs_modulus": 1e8, "friction": 0.5},
        "steel": {"density": 7800, "youngs_modulus": 1e8, "friction": 0.3, "normal_damping": 0.2}
    },
    "pairs": [{"materials": ["rock", "steel"], "friction": 0.4}],
    "shapes": {
        "floor": {"half_space": {"normal": [0, 0, 1]}},
        "plate": {"box": [0.4, 0.4, 0.04]},
        "crate": {"box": [0.1, 0.1, 0.1]},
        "ball": {"sphere": 0.05},
        "stone": {"mesh": ")" SCREE_SOURCE_DIR R"(/meshes/stone_a.obj", "scale": 0.08}
    },
    "bodies": [
        {"name": "ground", "shape": "floor", "material": "rock", "motion": "fixed"},
        {"name": "shaker", "shape": "plate", "material": "steel", "position": [0, 0, 0.2],
         "motion": {"velocity": [0, 0, 1], "amplitude": 0.005, "frequency": 5}},
        {"name": "belt", "shape": "plate", "material": "rock", "position": [1, 0, 0.1],
         "motion": {"surface_velocity": [0.5, 0, 0]}},
        {"shape": "crate", "material": "rock", "position": [0.9, 0, 0.17]},
        {"name": "lower", "shape": "crate", "material": "rock", "position": [2, 0, 0.05]},
        {"name": "upper", "shape": "crate", "material": "steel", "position": [2, 0.01, 0.15]},
        {"shape": "ball", "material": "steel", "position": [3, 0, 0.05], "velocity": [1, 0, 0]}
    ],
    "fill": [{"shape": "stone", "material": "rock", "count": 6, "size": [0.8, 1.2],
              "box": [[-0.15, -0.15, 0.25], [0.15, 0.15, 0.5]], "seed": 3}],
    "stepping": {"rtol": 1e-2},
    "end_time": 0.3
})";

inline SceneDescription busy_scene_with(const std::vector<std::string>& settings) {
    return parse_scene(busy_scene, "folder/busy.json", settings);
}

}  // namespace scree::test
