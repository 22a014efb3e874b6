#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <scree/output/bodies_csv.hpp>
#include <scree/output/contacts_csv.hpp>
#include <scree/output/energy_csv.hpp>
#include <scree/output/output_folder.hpp>
#include <scree/output/run_summary.hpp>
#include <scree/scenes/simulation.hpp>

namespace scree {

/// Writes what a scene asks for, from a running simulation to its folder.
class Recorder {
  public:
    Recorder(const Simulation& simulation, const std::filesystem::path& folder);

    /// What there is at the present output time. Energy and contacts are known from the first tick on.
    void record();
    /// summary.json; `status` is done, interrupted or failed.
    void finish(const std::string& status);

    [[nodiscard]] const OutputFolder& folder() const { return folder_; }
    /// Wall time [s] since this was made.
    [[nodiscard]] double wall() const;

  private:
    using Clock = std::chrono::steady_clock;

    const Simulation& simulation_;
    Clock::time_point start_ = Clock::now();
    double writing_ = 0;  ///< [s]
    OutputFolder folder_;
    std::vector<std::string> names_;  ///< of the bodies
    std::optional<BodiesCsv> bodies_;
    std::optional<EnergyCsv> energy_;
    std::optional<ContactsCsv> contacts_;
};

}  // namespace scree
