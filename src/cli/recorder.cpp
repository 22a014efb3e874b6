#include "recorder.hpp"

#include "summary_of.hpp"

namespace scree {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Recorder::Recorder(const Simulation& simulation, const std::filesystem::path& folder)
    : simulation_(simulation), folder_(folder) {
    if (simulation.scene().output.bodies) {
        bodies_.emplace(folder_.file("bodies.csv"));
    }
}

void Recorder::record() {
    const Clock::time_point begin = Clock::now();
    if (bodies_) {
        bodies_->write(simulation_.time(), body_records(simulation_));
    }
    writing_ += seconds_since(begin);
}

void Recorder::finish(const std::string& status) {
    RunSummary summary = summary_of(simulation_);
    summary.status = status;
    summary.time.wall = wall();
    summary.time.output = writing_;
    write_whole(folder_.file("summary.json"), summary_json(summary));
}

double Recorder::wall() const {
    return seconds_since(start_);
}

}  // namespace scree
