#pragma once

#include <cmath>
#include <cstddef>

#include <scree/mesh/saved_state.hpp>

namespace scree {

/// Ends of ticks, each by one multiplication, so that the same times come out however often one starts again.
class TickClock {
  public:
    /// [s], the end of the last tick.
    [[nodiscard]] double now() const { return start_ + static_cast<double>(count_) * tick_; }

    /// [s], the end of the next one if it lasts `tick` [s]. Ticks that differ by rounding are the same.
    [[nodiscard]] double next(double tick) {
        if (!(std::abs(tick - tick_) <= 1e-9 * tick_)) {
            start_ = now();
            tick_ = tick;
            count_ = 0;
        }
        return start_ + static_cast<double>(count_ + 1) * tick_;
    }
    void advance() { ++count_; }

    friend void visit_state(auto& with, StateOf<TickClock> auto& clock) {
        auto& [start, tick, count] = clock;
        with(start, tick, count);
    }

  private:
    double start_ = 0;
    double tick_ = 0;
    std::size_t count_ = 0;
};

}  // namespace scree
