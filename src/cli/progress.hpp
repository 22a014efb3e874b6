#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include <scree/scenes/simulation.hpp>

namespace scree {

/// One line on a terminal's standard error that says how far a run is, with a clock that goes on while a tick
/// lasts; nothing where there is no terminal.
class Progress {
  public:
    Progress(const Simulation& simulation, double end, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Call between ticks.
    void show();

  private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] std::string line();
    [[nodiscard]] double remaining() const;
    void draw();

    const Simulation& simulation_;
    double end_;    ///< [s], of the run
    double begin_;  ///< [s], where it set in
    Clock::time_point start_ = Clock::now();
    SteppingStatistics before_;  ///< as of the last line but one that says anything of steps
    std::size_t order_ = 1;
    double step_ = 0;  ///< [s]

    std::mutex mutex_;
    std::string line_;
    bool over_ = false;
    std::condition_variable ended_;
    std::thread drawer_;
};

}  // namespace scree
