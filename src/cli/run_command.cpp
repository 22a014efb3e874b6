#include <cstdio>

#include <scree/scenes/find_scene.hpp>
#include <scree/scenes/read_scene.hpp>

#include "commands.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "recorder.hpp"

namespace scree {

namespace {

/// From tick to tick until the last one, a failure or Ctrl-C. Returns the status.
ExitStatus run_ticks(Simulation& simulation, std::int64_t last, Recorder& recorder, Progress& progress) {
    recorder.record();
    while (simulation.tick() < last) {
        if (interrupted()) {
            return exit_interrupted;
        }
        if (!simulation.advance()) {
            return exit_failed;
        }
        recorder.record();
        progress.show();
    }
    return exit_done;
}

const char* status_word(ExitStatus status) {
    return status == exit_done ? "done" : status == exit_interrupted ? "interrupted" : "failed";
}

void print_notes(const Simulation& simulation) {
    for (const std::string& note : simulation.notes()) {
        std::printf("note: %s\n", note.c_str());
    }
}

void print_closing_line(const Simulation& simulation, const Recorder& recorder, ExitStatus status) {
    std::printf("%s: %s at %.6g s, %zu steps in %.3g s; see %s\n", simulation.scene().name.c_str(),
                status_word(status), simulation.time(), simulation.report().steps.accepted, recorder.wall(),
                recorder.folder().path().c_str());
}

}  // namespace

int run_command(const RunRequest& request) {
    const SceneDescription scene = read_scene(find_scene(request.scene), request.settings);
    Simulation simulation(scene);
    const OutputTimes& times = simulation.times();
    const std::int64_t last = request.until ? times.last_until(*request.until) : times.last();

    catch_interrupt();
    Recorder recorder(simulation, request.out.empty() ? "out/" + scene.name : request.out);
    ExitStatus status = exit_done;
    {
        Progress progress(simulation, times.at(last), request.quiet);
        status = run_ticks(simulation, last, recorder, progress);
    }
    recorder.finish(status_word(status));
    if (!request.quiet) {
        print_notes(simulation);
        print_closing_line(simulation, recorder, status);
    }
    if (status == exit_failed) {
        const StepReport& report = simulation.report();
        std::fprintf(stderr, "scree: %s: stopped at %.17g s: %s\n", scene.name.c_str(), report.time,
                     report.message.c_str());
    }
    return status;
}

}  // namespace scree
