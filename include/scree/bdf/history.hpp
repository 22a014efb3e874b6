#pragma once

#include <span>
#include <vector>

#include <scree/bdf/coefficients.hpp>
#include <scree/dynamics/trial.hpp>

namespace scree {

/// Accepted states of all bodies at past times, the latest first; as many as the highest order's error test
/// needs. Quaternions of successive times are on one side of the sphere.
class StateHistory {
  public:
    static constexpr std::size_t most =
        highest_order + 2;  ///< states, for the error weights of the highest order plus one

    /// Forgets everything but this state.
    void restart(double time, const std::vector<BodyState>& states);
    /// An accepted step.
    void push(double time, const std::vector<BodyState>& states);
    /// Older values behind those that are there; the times must go down.
    void append(double time, const std::vector<BodyState>& states);

    /// How many states there are.
    [[nodiscard]] std::size_t count() const { return times_.size(); }
    /// Their times [s], the latest first.
    [[nodiscard]] std::span<const double> times() const { return times_; }
    /// All bodies at the j-th of them.
    [[nodiscard]] const std::vector<BodyState>& states(std::size_t j) const { return states_[j]; }

    /// Σ formula.past[j] y_{n−j} for each body.
    void start(const BdfFormula& formula, std::size_t order, std::vector<BodyStart>& starts) const;

    /// Makes a body's past what would have led to its present state had this much more force [N] and torque
    /// [N m] acted: so that a formula goes smoothly over a jump in what acts from outside.
    void assume(std::size_t body, const Body& what, const Vec3& force, const Vec3& torque);

    /// A body's state at a time between the oldest and the latest, by the polynomial through the latest
    /// `points` values.
    [[nodiscard]] BodyState at(double time, std::size_t body, std::size_t points) const;

    friend void visit_state(auto& with, StateOf<StateHistory> auto& history) {
        auto& [times, states] = history;
        std::size_t count = times.size();
        with.up_to(most, count);
        with.first(count, times);
        with.first(count, states);
    }

  private:
    std::vector<double> times_;
    std::vector<std::vector<BodyState>> states_;  ///< at least as many as times
};

}  // namespace scree
