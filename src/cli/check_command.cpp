#include <cstdio>

#include <scree/scenes/features.hpp>
#include <scree/scenes/find_scene.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

#include "commands.hpp"

namespace scree {

namespace {

void print_list(const char* title, const std::vector<std::string>& words) {
    std::printf("%s:", title);
    for (const std::string& word : words) {
        std::printf(" %s", word.c_str());
    }
    std::printf("\n");
}

}  // namespace

int check_command(const RunRequest& request) {
    const SceneDescription scene = read_scene(find_scene(request.scene), request.settings);
    const Simulation simulation(scene);
    if (request.quiet) {
        return exit_done;
    }
    const Features features = scene_features(scene);
    std::printf("%s: %zu bodies for %.6g s, an output every %.6g s\n", scene.name.c_str(),
                simulation.bodies().size(), scene.end_time, scene.output.every);
    print_list("used", features.used);
    print_list("left out", features.left_out);
    for (const std::string& note : simulation.notes()) {
        std::printf("note: %s\n", note.c_str());
    }
    return exit_done;
}

}  // namespace scree
