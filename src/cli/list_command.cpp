#include <algorithm>
#include <cstdio>

#include <scree/scenes/find_scene.hpp>

#include "commands.hpp"

namespace scree {

int list_command(bool quiet) {
    const std::vector<ShippedScene> scenes = shipped_scenes();
    std::size_t width = 0;
    for (const ShippedScene& scene : scenes) {
        width = std::max(width, scene.name.size());
    }
    for (const ShippedScene& scene : scenes) {
        std::printf("%-*s  %s\n", static_cast<int>(width), scene.name.c_str(),
                    quiet ? "" : scene.purpose.c_str());
    }
    return exit_done;
}

}  // namespace scree
