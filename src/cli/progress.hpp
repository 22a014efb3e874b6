#pragma once

#include <chrono>

#include <scree/scenes/simulation.hpp>

namespace scree {

/// One line on a terminal's standard error that says how far a run is; nothing where there is no terminal.
class Progress {
  public:
    Progress(const Simulation& simulation, double end, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Call after every tick; redraws at most ten times a second.
    void show();

  private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] double remaining() const;

    const Simulation& simulation_;
    double end_;  ///< [s], of the run
    bool enabled_;
    Clock::time_point start_, last_;
    SteppingStatistics before_;  ///< as of the last line drawn
};

}  // namespace scree
