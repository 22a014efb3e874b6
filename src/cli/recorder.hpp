#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <scree/output/bodies_csv.hpp>
#include <scree/output/checkpoint.hpp>
#include <scree/output/contacts_csv.hpp>
#include <scree/output/energy_csv.hpp>
#include <scree/output/output_folder.hpp>
#include <scree/output/pose_spool.hpp>
#include <scree/output/shown_scene.hpp>
#include <scree/scenes/simulation.hpp>

#include "frame_writer.hpp"

namespace scree {

/// Writes what a scene asks for, from a running simulation to its folder. Throws OutputError.
class Recorder {
  public:
    /// Of a run that begins.
    Recorder(const Simulation& simulation, const std::filesystem::path& folder);
    /// Of one that goes on from a checkpoint, in the folder where that lies.
    Recorder(const Simulation& simulation, const std::filesystem::path& folder, const Checkpoint& from);

    /// Before the first tick.
    void begin();
    /// After each.
    void record();
    /// After the last one: what it takes to go on if there is more to come, the replay, then summary.json;
    /// `status` is done, interrupted or failed.
    void finish(const std::string& status);

    [[nodiscard]] const OutputFolder& folder() const { return folder_; }
    /// Wall time [s] that the run has taken.
    [[nodiscard]] double wall() const;

  private:
    using Clock = std::chrono::steady_clock;

    Recorder(const Simulation& simulation, OutputFolder folder, const Checkpoint* from);
    [[nodiscard]] std::vector<AppendedFile*> files();
    void write_rows();
    void write_replay();
    [[nodiscard]] bool checkpoint_is_due() const;
    void write_checkpoint();

    const Simulation& simulation_;
    Clock::time_point start_ = Clock::now();
    double wall_before_ = 0;  ///< [s], before this was made
    double writing_ = 0;      ///< [s]
    OutputFolder folder_;
    std::int64_t checkpoint_ = -1;    ///< output time of the last one
    std::vector<std::string> names_;  ///< of the bodies
    std::optional<BodiesCsv> bodies_;
    std::optional<EnergyCsv> energy_;
    std::optional<ContactsCsv> contacts_;
    ShownScene shown_;  ///< of the replay and the frames
    std::optional<PoseSpool> poses_;
    std::optional<FrameWriter> frames_;
};

}  // namespace scree
