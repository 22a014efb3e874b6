#pragma once

#include <cstddef>

namespace scree {

/// Ends of ticks, each by one multiplication, so that the same times come out however often one starts again.
class TickClock {
  public:
    /// [s], the end of the last tick.
    [[nodiscard]] double now() const { return start_ + static_cast<double>(count_) * tick_; }

    /// [s], the end of the next one if it lasts `tick` [s].
    [[nodiscard]] double next(double tick) {
        if (tick != tick_) {
            start_ = now();
            tick_ = tick;
            count_ = 0;
        }
        return start_ + static_cast<double>(count_ + 1) * tick_;
    }
    void advance() { ++count_; }

  private:
    double start_ = 0;
    double tick_ = 0;
    std::size_t count_ = 0;
};

}  // namespace scree
