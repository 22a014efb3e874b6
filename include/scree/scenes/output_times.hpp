#pragma once

#include <cstdint>

namespace scree {

/// When a run writes, and where its ticks end: at i · every, one multiplication, and at its end.
class OutputTimes {
  public:
    /// Both in seconds, above 0.
    OutputTimes(double every, double end);

    /// The number of the last one; the first is 0, at time 0.
    [[nodiscard]] std::int64_t last() const { return last_; }
    /// The time [s] of the i-th.
    [[nodiscard]] double at(std::int64_t i) const;
    /// The number of the last one that is no later than `time` [s], to 10⁻¹² of it.
    [[nodiscard]] std::int64_t last_until(double time) const;

  private:
    double every_;
    double end_;
    std::int64_t last_;
};

}  // namespace scree
