#include <scree/bdf/history.hpp>

#include <algorithm>

namespace scree {

namespace {

// Turns the quaternions of `states` to the side on which those of `reference` are.
void take_sides(const std::vector<BodyState>& reference, std::vector<BodyState>& states) {
    for (std::size_t b = 0; b < states.size(); ++b) {
        Quat& q = states[b].orientation;
        if (q.dot(reference[b].orientation) < 0) {
            q.coeffs() = -q.coeffs();
        }
    }
}

}  // namespace

void StateHistory::restart(double time, const std::vector<BodyState>& states) {
    times_.assign(1, time);
    states_.resize(std::max<std::size_t>(states_.size(), 1));
    states_.front() = states;
}

void StateHistory::push(double time, const std::vector<BodyState>& states) {
    if (states_.size() < most) {
        states_.emplace_back();
    }
    if (times_.size() == most) {
        times_.pop_back();
    }
    times_.insert(times_.begin(), time);
    std::rotate(states_.begin(), states_.end() - 1, states_.end());
    states_.front() = states;
    take_sides(states_[1], states_.front());
}

void StateHistory::append(double time, const std::vector<BodyState>& states) {
    times_.push_back(time);
    states_.resize(std::max(states_.size(), times_.size()));
    std::vector<BodyState>& oldest = states_[times_.size() - 1];
    oldest = states;
    take_sides(states_[times_.size() - 2], oldest);
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

void StateHistory::assume(std::size_t body, const Body& what, const Vec3& force, const Vec3& torque) {
    BodyState change;
    change.orientation = states_.front()[body].orientation;
    change.momentum = force;
    change.angular_momentum = torque;
    const Vec3 faster = velocity(what, change);
    const Vec3 turning = spin(what, change);
    for (std::size_t j = 1; j < times_.size(); ++j) {
        const double ago = times_[j] - times_[0];
        BodyState& past = states_[j][body];
        past.position += 0.5 * ago * ago * faster;
        const Vec3 half = 0.25 * ago * ago * turning;
        past.orientation = (Quat(1, half.x(), half.y(), half.z()) * past.orientation).normalized();
        past.momentum += ago * force;
        past.angular_momentum += ago * torque;
    }
}

BodyState StateHistory::at(double time, std::size_t body, std::size_t points) const {
    const auto weights = extrapolation(time, times_, points);
    const BodyState& last = states_.front()[body];
    BodyState sum = last;
    Eigen::Vector4d turn = last.orientation.coeffs();
    for (std::size_t j = 1; j < points; ++j) {
        const BodyState& past = states_[j][body];
        sum.position += weights[j] * (past.position - last.position);
        sum.momentum += weights[j] * (past.momentum - last.momentum);
        sum.angular_momentum += weights[j] * (past.angular_momentum - last.angular_momentum);
        turn += weights[j] * (past.orientation.coeffs() - last.orientation.coeffs());
    }
    sum.orientation = Quat(turn).normalized();
    return sum;
}

}  // namespace scree
