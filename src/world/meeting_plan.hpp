#pragma once

#include <functional>

#include <scree/dynamics/step_problem.hpp>

namespace scree {

/// When the groups meet next. The longer they go apart, the farther bodies may come, and the more of them
/// must count as possibly touching; so the time is such that they are not many more than those that do touch.
class MeetingPlan {
  public:
    /// Chooses the time [s] to the next meeting, at most `left`, and a whole number of equal steps of at most
    /// `fixed_step` where that is above 0. `search(span)` finds the system's contacts for a span; those of
    /// the last call are those of the span chosen.
    double choose(double left, double fixed_step, const System& system,
                  const std::function<void(double)>& search);

    [[nodiscard]] double last() const { return last_; }

    friend void visit_state(auto& with, StateOf<MeetingPlan> auto& plan) {
        auto& [last] = plan;
        with(last);
    }

  private:
    double last_ = 0;  ///< [s] between the last two meetings; 0: none yet
};

}  // namespace scree
