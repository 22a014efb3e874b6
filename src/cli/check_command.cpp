#include <cstdio>

#include <scree/scenes/describe_scene.hpp>
#include <scree/scenes/find_scene.hpp>
#include <scree/scenes/read_scene.hpp>

#include "commands.hpp"

namespace scree {

int check_command(const RunRequest& request) {
    const Simulation simulation(read_scene(find_scene(request.scene), request.settings));
    if (!request.quiet) {
        for (const std::string& line : describe_scene(simulation)) {
            std::printf("%s\n", line.c_str());
        }
    }
    return exit_done;
}

}  // namespace scree
