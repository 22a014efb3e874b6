#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/bdf/stepper.hpp>
#include <scree/dynamics/stored_force.hpp>

namespace scree {

namespace {

// A NaN counts as the worst.
double worse(double a, double b) {
    return b <= a ? a : (b > a ? b : std::numeric_limits<double>::infinity());
}

template <class ErrorOf>
double largest_error(std::span<const Body> bodies, const ErrorScale& scale, ErrorOf&& error_of) {
    double largest = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].dynamic()) {
            largest = worse(largest, scale.norm(b, error_of(b)));
        }
    }
    return largest;
}

}  // namespace

// A force that jumps within the step makes an error of first order whatever the order; that happens once, and
// need not be held to what many steps together may make.
double Stepper::allowed_error(std::size_t order) const {
    return failures_ < most_failures ? options_.tolerances.a_step(order) : options_.tolerances.sum();
}

double Stepper::local_error(double time, std::size_t order) const {
    const double allowed = allowed_error(order);
    if (memory_.past.count() < order + 1) {
        return first_error(time - memory_.time) / allowed;
    }
    double largest = largest_difference(time, order);
    const auto all = error_weights(time, memory_.past.times(), order);
    const auto weights = std::span(all).first(order + 2);
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
        largest = worse(largest, friction_error(system_.contacts[i], problem_.results()[i], weights));
    }
    return largest / allowed;
}

// The error of a formula of this order is its scaled difference of one order more.
double Stepper::largest_difference(double time, std::size_t order) const {
    const ErrorScale scale(system_.bodies, problem_.trial(), options_.tolerances.gravity);
    const auto weights = error_weights(time, memory_.past.times(), order);
    return largest_error(system_.bodies, scale,
                         [&](std::size_t b) { return body_error(b, std::span(weights).first(order + 2)); });
}

// weights: of the new state and the past ones.
BodyError Stepper::body_error(std::size_t b, std::span<const double> weights) const {
    const BodyState& now = trial_states_[b];
    BodyState sum;
    Eigen::Vector4d turn = Eigen::Vector4d::Zero();
    const Quat sided = now.orientation.dot(memory_.past.states(0)[b].orientation) < 0
                           ? Quat(Eigen::Vector4d(-now.orientation.coeffs()))
                           : now.orientation;
    for (std::size_t k = 1; k < weights.size(); ++k) {
        const BodyState& past = memory_.past.states(k - 1)[b];
        sum.position += weights[k] * (past.position - now.position);
        sum.momentum += weights[k] * (past.momentum - now.momentum);
        sum.angular_momentum += weights[k] * (past.angular_momentum - now.angular_momentum);
        turn += weights[k] * (past.orientation.coeffs() - sided.coeffs());
    }
    sum.orientation = now.orientation;
    const Vec3 angle = 2 * (Quat(turn) * sided.conjugate()).vec();
    return {sum.position, angle, velocity(system_.bodies[b], sum), spin(system_.bodies[b], sum)};
}

// A stuck contact's stored force is a state too: its error as the distance that it stands for, in the
// position's weight.
double Stepper::friction_error(const Contact& contact, const ContactResult& result,
                               std::span<const double> weights) const {
    const std::size_t values = weights.size() - 1;
    if (!remembers(contact, result, values)) {
        return 0;
    }
    std::array<Quat, highest_order> turns_a, turns_b;
    for (std::size_t j = 0; j < values; ++j) {
        turns_a[j] = turn_since(static_cast<std::size_t>(contact.a.body), j);
        turns_b[j] = turn_since(static_cast<std::size_t>(contact.b.body), j);
    }
    const double size = 0.5 * contact.pair.length;  // of two like bodies the radius
    return stored_difference(contact, result, weights, turns_a, turns_b) / (size * std::sqrt(12.0));
}

Quat Stepper::turn_since(std::size_t body, std::size_t j) const {
    const Quat before = memory_.past.states(j)[body].orientation;
    const Quat turn = problem_.trial()[body].pose.orientation * before.conjugate();
    return turn.w() < 0 ? Quat(-turn.coeffs()) : turn;
}

// Without enough past: half of what the new state differs from the tangent at the old one.
double Stepper::first_error(double step) const {
    const ErrorScale scale(system_.bodies, problem_.trial(), options_.tolerances.gravity);
    return largest_error(system_.bodies, scale, [&](std::size_t b) -> BodyError {
        const Body& body = system_.bodies[b];
        const BodyState& old = system_.states[b];
        const BodyState& now = trial_states_[b];
        BodyState change = now;
        change.momentum -= old.momentum + step * memory_.force[b];
        change.angular_momentum -= old.angular_momentum + step * memory_.torque[b];
        const Vec3 moved = now.position - old.position - step * velocity(body, old);
        const Quat turn = now.orientation * old.orientation.conjugate();
        const Vec3 turned = 2 * (turn.w() < 0 ? -1 : 1) * turn.vec() - step * spin(body, old);
        return {0.5 * moved, 0.5 * turned, 0.5 * velocity(body, change), 0.5 * spin(body, change)};
    });
}

}  // namespace scree
