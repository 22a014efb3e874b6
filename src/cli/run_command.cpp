#include <scree/scenes/find_scene.hpp>
#include <scree/scenes/read_scene.hpp>

#include "commands.hpp"
#include "run_loop.hpp"

namespace scree {

int run_command(const RunRequest& request) {
    const SceneDescription scene = read_scene(find_scene(request.scene), request.settings);
    Simulation simulation(scene);
    simulation.set_threads(static_cast<std::size_t>(request.threads));
    Recorder recorder(simulation, request.out.empty() ? "out/" + scene.name : request.out);
    return run_to_end(simulation, recorder, request.until, request.quiet);
}

}  // namespace scree
