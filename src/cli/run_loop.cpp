#include "run_loop.hpp"

#include <cstdio>

#include "interrupt.hpp"
#include "progress.hpp"

namespace scree {

namespace {

/// From tick to tick until the last one, a failure or Ctrl-C.
ExitStatus run_ticks(Simulation& simulation, std::int64_t last, Recorder& recorder, Progress& progress) {
    recorder.begin();
    while (simulation.tick() < last) {
        if (interrupted()) {
            return exit_interrupted;
        }
        progress.show();
        if (!simulation.advance()) {
            return exit_failed;
        }
        recorder.record();
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

ExitStatus run_to_end(Simulation& simulation, Recorder& recorder, std::optional<double> until, bool quiet) {
    const OutputTimes& times = simulation.times();
    const std::int64_t last = until ? times.last_until(*until) : times.last();
    catch_interrupt();
    ExitStatus status = exit_done;
    {
        Progress progress(simulation, times.at(last), quiet);
        status = run_ticks(simulation, last, recorder, progress);
    }
    recorder.finish(status_word(status));
    if (!quiet) {
        print_notes(simulation);
        print_closing_line(simulation, recorder, status);
    }
    if (status == exit_failed) {
        const StepReport& report = simulation.report();
        std::fprintf(stderr, "scree: %s: stopped at %.17g s: %s\n", simulation.scene().name.c_str(),
                     report.time, report.message.c_str());
    }
    return status;
}

}  // namespace scree
