#include <cstdio>

#include <scree/output/run_summary.hpp>
#include <scree/scenes/read_scene.hpp>

#include "commands.hpp"
#include "run_loop.hpp"

namespace scree {

namespace {

/// Refuses meshes that are not what the run began with.
void check_shapes(const Simulation& simulation, const Checkpoint& checkpoint) {
    for (const auto& [name, solid] : simulation.solids()) {
        const auto known = checkpoint.shapes.find(name);
        if (known == checkpoint.shapes.end() || !(known->second == geometry_of(solid))) {
            throw SceneError(checkpoint.scene_file + ": shapes." + name, "another geometry than the run has",
                             "that with which it began");
        }
    }
}

void restore(const Checkpoint& checkpoint, const std::filesystem::path& file, Simulation& simulation) {
    try {
        simulation.restore(checkpoint.state);
    } catch (const StateError& error) {
        throw OutputError(file, error.what(), "one of it");
    }
}

}  // namespace

int resume_command(const ResumeRequest& request) {
    const OutputFolder folder(request.folder, OutputFolder::Contents::kept);
    if (is_finished(folder.file("summary.json"))) {
        if (!request.quiet) {
            std::printf("%s: done already\n", request.folder.c_str());
        }
        return exit_done;
    }
    const std::filesystem::path file = folder.file(Checkpoint::file_name);
    const Checkpoint checkpoint = read_checkpoint(file);
    Simulation simulation(parse_scene(checkpoint.scene, checkpoint.scene_file));
    check_shapes(simulation, checkpoint);
    simulation.set_threads(static_cast<std::size_t>(request.threads));
    restore(checkpoint, file, simulation);
    Recorder recorder(simulation, request.folder, checkpoint);
    return run_to_end(simulation, recorder, request.until, request.quiet);
}

}  // namespace scree
