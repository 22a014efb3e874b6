#include <scree/bdf/history.hpp>

#include <algorithm>

namespace scree {

namespace {

constexpr std::size_t most = highest_order + 2;

}  // namespace

void StateHistory::restart(double time, const std::vector<BodyState>& states) {
    times_.assign(1, time);
    states_.assign(1, states);
}

void StateHistory::push(double time, const std::vector<BodyState>& states) {
    std::vector<BodyState> recycled;
    if (times_.size() == most) {
        times_.pop_back();
        recycled = std::move(states_.back());
        states_.pop_back();
    }
    recycled = states;
    for (std::size_t b = 0; b < recycled.size(); ++b) {
        Quat& q = recycled[b].orientation;
        if (q.dot(states_.front()[b].orientation) < 0) {
            q.coeffs() = -q.coeffs();
        }
    }
    times_.insert(times_.begin(), time);
    states_.push_front(std::move(recycled));
}

// Written as the last value plus differences, which are small, so that rounding stays at that of one
// addition.
void StateHistory::start(const BdfFormula& formula, std::size_t order, std::vector<BodyStart>& starts) const {
    const std::vector<BodyState>& last = states_.front();
    starts.resize(last.size());
    for (std::size_t b = 0; b < last.size(); ++b) {
        BodyStart sum;
        Eigen::Vector4d turn = Eigen::Vector4d::Zero();
        sum.past_orientations[0] = last[b].orientation;
        for (std::size_t j = 1; j < order; ++j) {
            const BodyState& past = states_[j][b];
            sum.position += formula.past[j] * (past.position - last[b].position);
            sum.momentum += formula.past[j] * (past.momentum - last[b].momentum);
            sum.angular_momentum += formula.past[j] * (past.angular_momentum - last[b].angular_momentum);
            turn += formula.past[j] * (past.orientation.coeffs() - last[b].orientation.coeffs());
            sum.past_orientations[j] = past.orientation;
        }
        sum.position += last[b].position;
        sum.momentum += last[b].momentum;
        sum.angular_momentum += last[b].angular_momentum;
        sum.orientation = last[b].orientation.coeffs() + turn;
        starts[b] = sum;
    }
}

}  // namespace scree
