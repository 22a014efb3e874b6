#pragma once

#include <deque>
#include <span>
#include <vector>

#include <scree/bdf/coefficients.hpp>
#include <scree/dynamics/trial.hpp>

namespace scree {

/// Accepted states of all bodies at past times, the latest first; as many as the highest order's error test
/// needs.
class StateHistory {
  public:
    /// Forgets everything but this state.
    void restart(double time, const std::vector<BodyState>& states);
    /// An accepted step. Quaternions are kept on the side of the sphere where the last ones are.
    void push(double time, const std::vector<BodyState>& states);

    [[nodiscard]] std::size_t count() const { return times_.size(); }
    [[nodiscard]] std::span<const double> times() const { return times_; }
    [[nodiscard]] const std::vector<BodyState>& states(std::size_t j) const { return states_[j]; }

    /// Σ formula.past[j] y_{n−j} for each body.
    void start(const BdfFormula& formula, std::size_t order, std::vector<BodyStart>& starts) const;

  private:
    std::vector<double> times_;
    std::deque<std::vector<BodyState>> states_;
};

}  // namespace scree
