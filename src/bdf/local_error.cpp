// What a step leaves out, estimated from the divided differences of the states.

#include <algorithm>

#include <scree/bdf/stepper.hpp>

namespace scree {

double Stepper::largest_error(const std::function<BodyError(std::size_t)>& error_of) const {
    const ErrorScale scale(system_.bodies, problem_.trial(), options_.tolerances.gravity);
    double largest = 0;
    for (std::size_t b = 0; b < system_.bodies.size(); ++b) {
        if (system_.bodies[b].dynamic()) {
            largest = std::max(largest, scale.norm(b, error_of(b)));
        }
    }
    return largest;
}

double Stepper::local_error(double time, std::size_t order) const {
    if (history_.count() < order + 1) {
        return first_error(time - time_);
    }
    const auto weights = error_weights(time, history_.times(), order);
    return largest_error([&](std::size_t b) { return body_error(b, std::span(weights).first(order + 2)); });
}

// weights: of the new state and the past ones.
BodyError Stepper::body_error(std::size_t b, std::span<const double> weights) const {
    const BodyState& now = trial_states_[b];
    BodyState sum;
    Eigen::Vector4d turn = Eigen::Vector4d::Zero();
    const Quat sided = now.orientation.dot(history_.states(0)[b].orientation) < 0
                           ? Quat(Eigen::Vector4d(-now.orientation.coeffs()))
                           : now.orientation;
    for (std::size_t k = 1; k < weights.size(); ++k) {
        const BodyState& past = history_.states(k - 1)[b];
        sum.position += weights[k] * (past.position - now.position);
        sum.momentum += weights[k] * (past.momentum - now.momentum);
        sum.angular_momentum += weights[k] * (past.angular_momentum - now.angular_momentum);
        turn += weights[k] * (past.orientation.coeffs() - sided.coeffs());
    }
    sum.orientation = now.orientation;
    const Vec3 angle = 2 * (Quat(turn) * sided.conjugate()).vec();
    return {sum.position, angle, velocity(system_.bodies[b], sum), spin(system_.bodies[b], sum)};
}

// Without enough past: half of what the new state differs from the tangent at the old one.
double Stepper::first_error(double step) const {
    return largest_error([&](std::size_t b) -> BodyError {
        const Body& body = system_.bodies[b];
        const BodyState& old = system_.states[b];
        const BodyState& now = trial_states_[b];
        BodyState change = now;
        change.momentum -= old.momentum + step * first_force_[b];
        change.angular_momentum -= old.angular_momentum + step * first_torque_[b];
        const Vec3 moved = now.position - old.position - step * velocity(body, old);
        const Quat turn = now.orientation * old.orientation.conjugate();
        const Vec3 turned = 2 * (turn.w() < 0 ? -1 : 1) * turn.vec() - step * spin(body, old);
        return {0.5 * moved, 0.5 * turned, 0.5 * velocity(body, change), 0.5 * spin(body, change)};
    });
}

}  // namespace scree
