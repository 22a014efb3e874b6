#include "recorder.hpp"

#include <algorithm>
#include <cmath>

#include <scree/dynamics/stopwatch.hpp>
#include <scree/output/gltf.hpp>

#include "shown_scene_of.hpp"
#include "summary_of.hpp"

namespace scree {

namespace {

constexpr double rounding = 1e-12;  // of a time

std::vector<std::string> names_of(const Simulation& simulation) {
    std::vector<std::string> names;
    for (const SimulationBody& body : simulation.bodies()) {
        names.push_back(body.name);
    }
    return names;
}

/// How much of a file belongs to the checkpoint.
std::optional<std::uint64_t> kept(const Checkpoint* from, const OutputFolder& folder, const char* name) {
    if (from == nullptr) {
        return std::nullopt;
    }
    const auto found = from->files.find(name);
    if (found == from->files.end()) {
        throw OutputError(folder.file(Checkpoint::file_name), std::string("nothing of ") + name, "its size");
    }
    return found->second;
}

}  // namespace

Recorder::Recorder(const Simulation& simulation, const std::filesystem::path& folder)
    : Recorder(simulation, OutputFolder(folder), nullptr) {}

Recorder::Recorder(const Simulation& simulation, const std::filesystem::path& folder, const Checkpoint& from)
    : Recorder(simulation, OutputFolder(folder, OutputFolder::Contents::kept), &from) {
    checkpoint_ = simulation.tick();
    wall_before_ = from.wall;
    writing_ = from.writing;
}

Recorder::Recorder(const Simulation& simulation, OutputFolder folder, const Checkpoint* from)
    : simulation_(simulation), folder_(std::move(folder)) {
    const OutputDescription& wanted = simulation.scene().output;
    const auto open = [&](auto& table, const char* name) {
        table.emplace(folder_.file(name), kept(from, folder_, name));
    };
    if (wanted.bodies) {
        open(bodies_, "bodies.csv");
    }
    if (wanted.energy) {
        open(energy_, "energy.csv");
    }
    if (wanted.contacts) {
        open(contacts_, "contacts.csv");
        names_ = names_of(simulation);
    }
    if (wanted.replay || wanted.vtk) {
        shown_ = shown_scene_of(simulation);
    }
    if (wanted.vtk) {
        frames_.emplace(simulation, folder_, shown_);
    }
    if (wanted.replay) {
        const auto moving = std::count_if(simulation.bodies().begin(), simulation.bodies().end(), moves);
        poses_.emplace(folder_.file(PoseSpool::file_name), static_cast<std::size_t>(moving),
                       kept(from, folder_, PoseSpool::file_name));
    }
}

void Recorder::begin() {
    if (checkpoint_ >= 0) {
        return;  // a checkpoint has it all
    }
    const Stopwatch watch(writing_);
    write_rows();
    if (simulation_.scene().output.checkpoint_every > 0) {
        write_checkpoint();
    }
}

void Recorder::record() {
    const Stopwatch watch(writing_);
    write_rows();
    if (checkpoint_is_due()) {
        write_checkpoint();
    }
}

// Energy and contacts are known from the first tick on.
void Recorder::write_rows() {
    const double time = simulation_.time();
    if (bodies_) {
        bodies_->write(time, body_records(simulation_));
    }
    if (energy_ && simulation_.tick() > 0) {
        energy_->write(time, simulation_.report().energy);
    }
    if (contacts_ && simulation_.tick() > 0) {
        contacts_->write(time, simulation_.contacts(), simulation_.contact_results(), names_);
    }
    if (poses_) {
        poses_->add(time, simulation_.report().contacts, moving_poses(simulation_));
    }
    if (frames_) {
        frames_->write();
    }
}

// Of all there is so far. What it was made from goes with the last output time.
void Recorder::write_replay() {
    const Stopwatch watch(writing_);
    write_whole(folder_.file("replay.glb"), replay_glb(shown_, *poses_));
    if (simulation_.tick() == simulation_.times().last()) {
        std::filesystem::remove(folder_.file(PoseSpool::file_name));
    }
}

// At the first output time of each period.
bool Recorder::checkpoint_is_due() const {
    const double period = simulation_.scene().output.checkpoint_every;
    const auto periods = [&](std::int64_t tick) {
        return std::floor(simulation_.times().at(tick) / period * (1 + rounding));
    };
    return period > 0 && periods(simulation_.tick()) > periods(simulation_.tick() - 1);
}

std::vector<AppendedFile*> Recorder::files() {
    std::vector<AppendedFile*> files;
    const auto add = [&](auto& table) {
        if (table) {
            files.push_back(&table->file());
        }
    };
    add(bodies_);
    add(energy_);
    add(contacts_);
    add(poses_);
    return files;
}

// The tables first, so that a checkpoint never knows more than they hold.
void Recorder::write_checkpoint() {
    const SceneDescription& scene = simulation_.scene();
    Checkpoint checkpoint;
    checkpoint.scene = scene.text;
    checkpoint.scene_file = std::filesystem::absolute(scene.file).string();
    for (const auto& [name, solid] : simulation_.solids()) {
        checkpoint.shapes[name] = geometry_of(solid);
    }
    for (AppendedFile* file : files()) {
        file->sync();
        checkpoint.files[file->path().filename().string()] = file->size();
    }
    checkpoint.wall = wall();
    checkpoint.writing = writing_;
    checkpoint.state = simulation_.save();
    if (frames_) {
        frames_->write_list();
    }
    write_whole(folder_.file(Checkpoint::file_name), checkpoint_bytes(checkpoint));
    checkpoint_ = simulation_.tick();
}

void Recorder::finish(const std::string& status) {
    const std::int64_t tick = simulation_.tick();
    if (!simulation_.report().failed && tick < simulation_.times().last() && tick != checkpoint_) {
        write_checkpoint();
    }
    if (frames_) {
        frames_->write_list();
    }
    if (poses_) {
        write_replay();
    }
    RunSummary summary = summary_of(simulation_);
    summary.status = status;
    summary.time.wall = wall();
    summary.time.output = writing_;
    write_whole(folder_.file("summary.json"), summary_json(summary));
}

double Recorder::wall() const {
    return wall_before_ + std::chrono::duration<double>(Clock::now() - start_).count();
}

}  // namespace scree
