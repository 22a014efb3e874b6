#pragma once

#include <chrono>

namespace scree {

/// Adds the wall time of its own life to a sum [s].
class Stopwatch {
  public:
    /// Starts; `sum` must outlive it.
    explicit Stopwatch(double& sum) : sum_(sum) {}
    ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& sum_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace scree
