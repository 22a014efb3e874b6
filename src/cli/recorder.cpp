#include "recorder.hpp"

#include "summary_of.hpp"

namespace scree {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::string> names_of(const Simulation& simulation) {
    std::vector<std::string> names;
    for (const SimulationBody& body : simulation.bodies()) {
        names.push_back(body.name);
    }
    return names;
}

}  // namespace

Recorder::Recorder(const Simulation& simulation, const std::filesystem::path& folder)
    : simulation_(simulation), folder_(folder) {
    const OutputDescription& wanted = simulation.scene().output;
    if (wanted.bodies) {
        bodies_.emplace(folder_.file("bodies.csv"));
    }
    if (wanted.energy) {
        energy_.emplace(folder_.file("energy.csv"));
    }
    if (wanted.contacts) {
        contacts_.emplace(folder_.file("contacts.csv"));
        names_ = names_of(simulation);
    }
}

void Recorder::record() {
    const Clock::time_point begin = Clock::now();
    if (bodies_) {
        bodies_->write(simulation_.time(), body_records(simulation_));
    }
    if (energy_ && simulation_.tick() > 0) {
        energy_->write(simulation_.time(), simulation_.report().energy);
    }
    if (contacts_ && simulation_.tick() > 0) {
        contacts_->write(simulation_.time(), simulation_.contacts(), simulation_.contact_results(), names_);
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
