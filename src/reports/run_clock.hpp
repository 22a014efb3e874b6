#pragma once

#include <chrono>

namespace scree {

/// Times the parts of a run that count. On a machine that others use, too, the processor time says more than
/// the clock; but it is told in steps of milliseconds, so that short runs go by the clock, of which the least
/// of several is the undisturbed one.
class RunClock {
  public:
    void start();
    void stop();

    /// Of all parts so far [s].
    [[nodiscard]] double seconds() const;
    /// The same by the clock alone.
    [[nodiscard]] double by_clock() const { return clock_; }

  private:
    std::chrono::steady_clock::time_point part_;
    double part_processor_ = 0;
    double clock_ = 0;
    double processor_ = 0;  ///< its sum is exact in the mean, whatever the length of a part
};

}  // namespace scree
