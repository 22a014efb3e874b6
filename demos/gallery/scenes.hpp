#pragma once

#include "grains.hpp"
#include "machines.hpp"
#include "masonry.hpp"

namespace scree::gallery {

/// A scene with its checks and the moment of its picture.
struct Scene {
    const char* name;
    double picture;              ///< [s]
    std::function<Rows()> rows;  ///< null: it has a picture only
};

inline std::vector<Scene> scenes() {
    return {{"incline", 2, incline_rows},
            {"stack", 10, nullptr},
            {"tower", 10, tower_rows},
            {"arch", 5, arch_rows},
            {"arch_that_falls", 0.8, nullptr},
            {"wall", 0.25, wall_rows},
            {"conveyor", 2.1, conveyor_rows},
            {"vibrating_plate", 0.97, vibrating_plate_rows},
            {"drum", 2.5, drum_rows},
            {"hopper", 0.6, hopper_rows},
            {"repose", 2, repose_rows},
            {"packing", 1.2, packing_rows},
            {"pile", 2, pile_rows},
            {"sphere_heap", 1.5, nullptr}};
}

}  // namespace scree::gallery
