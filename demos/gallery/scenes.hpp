#pragma once

#include "grains.hpp"
#include "machines.hpp"
#include "masonry.hpp"

namespace scree::gallery {

/// A scene with its checks and the moment of its picture.
struct Scene {
    const char* name;
    double picture;  ///< [s]
    std::function<Rows()> rows;
};

inline std::vector<Scene> scenes() {
    return {{"incline", 2, incline_rows},   {"pile", 2, pile_rows},
            {"repose", 2, repose_rows},     {"hopper", 0.6, hopper_rows},
            {"drum", 2.5, drum_rows},       {"wall", 0.25, wall_rows},
            {"arch", 5, arch_rows},         {"vibrating_plate", 0.95, vibrating_plate_rows},
            {"packing", 1.2, packing_rows}, {"conveyor", 2.1, conveyor_rows},
            {"tower", 10, tower_rows}};
}

}  // namespace scree::gallery
