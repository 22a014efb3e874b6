#pragma once

#include <deque>
#include <span>
#include <vector>

#include <scree/bdf/coefficients.hpp>
#include <scree/dynamics/energy.hpp>

namespace scree {

/// Accepted states of all bodies at past times, the latest first; as many as the highest order's error test
/// needs.
class StateHistory {
  public:
    /// Forgets everything but this state.
    void restart(double time, const std::vector<BodyState>& states, const Accumulated& sums);
    /// An accepted step. Quaternions are kept on the side of the sphere where the last ones are.
    void push(double time, const std::vector<BodyState>& states, const Accumulated& sums);

    [[nodiscard]] std::size_t count() const { return times_.size(); }
    [[nodiscard]] std::span<const double> times() const { return times_; }
    [[nodiscard]] const std::vector<BodyState>& states(std::size_t j) const { return states_[j]; }

    [[nodiscard]] const Accumulated& sums() const { return sums_.front(); }  ///< the latest
    /// Σ formula.past[j] y_{n−j} of what is accumulated.
    [[nodiscard]] Accumulated start_sums(const BdfFormula& formula, std::size_t order) const;

    /// Σ formula.past[j] y_{n−j} for each body.
    void start(const BdfFormula& formula, std::size_t order, std::vector<BodyStart>& starts) const;

  private:
    std::vector<double> times_;
    std::deque<std::vector<BodyState>> states_;
    std::deque<Accumulated> sums_;
};

}  // namespace scree
