#include <scree/bdf/stepper.hpp>

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

// Those of CVODE: bias on the error of the present and the lower order, and of the higher one; least gain.
constexpr double bias = 6;
constexpr double bias_up = 10;
constexpr double least_gain = 1.5;
constexpr std::array<double, highest_order> most_growth{10, 2, 1.4, 1.4,
                                                        1.4};  // keeps the formula zero-stable
constexpr double most_shrink = 0.2;
constexpr double newton_shrink = 0.25;
constexpr double newton_share = 0.01;  // of the error tolerance, left to Newton's iteration
constexpr std::size_t brisk = 6;       // iterations a step, above which it does not grow
constexpr std::size_t hard = 10;       // above which it shrinks, for the sake of the work per second
constexpr double easing = 0.7;
constexpr double smallest_share = 1e-9;   // of a tick, below which a step is not tried
constexpr double first_share = 1e-3;      // of the time to fall or move by one's own radius
constexpr std::size_t most_failures = 3;  // before order 1

double gain(double error, double with_bias, std::size_t order) {
    return 1 / (std::pow(with_bias * error, 1.0 / static_cast<double>(order + 1)) + 1e-6);
}

}  // namespace

Stepper::Stepper(System& system, ContactForces& forces, const SteppingOptions& options)
    : system_(system), options_(options), problem_(system, forces) {}

void Stepper::restart(double time) {
    time_ = time;
    order_ = 1;
    held_ = 0;
    failures_ = 0;
    newton_.forget();
    history_.restart(time, system_.states);
    u_.resize(static_cast<Eigen::Index>(6 * system_.bodies.size()));
    // The forces at the start, for the first error estimate.
    StepFormulas formulas;
    formulas.past[0][0] = 1;
    history_.start({{1}, 0}, 1, starts_);
    problem_.begin(formulas, starts_);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < system_.bodies.size(); ++b) {
        const Body& body = system_.bodies[b];
        u_.segment<3>(static_cast<Eigen::Index>(6 * b)) = velocity(body, system_.states[b]);
        u_.segment<3>(static_cast<Eigen::Index>(6 * b + 3)) = spin(body, system_.states[b]);
        if (!body.dynamic()) {
            continue;
        }
        const double g = options_.tolerances.gravity;
        const double speed =
            velocity(body, system_.states[b]).norm() + spin(body, system_.states[b]).norm() * body.radius;
        if (g > 0) {
            least = std::min(least, std::sqrt(body.radius / g));
        }
        if (speed > 0) {
            least = std::min(least, body.radius / speed);
        }
    }
    problem_.evaluate(u_, Detail::force);
    first_force_ = problem_.forces();
    first_torque_ = problem_.torques();
    const double first = first_share * least;
    step_ = step_ > 0 ? std::min(step_, first) : first;
}

bool Stepper::step(double end) {
    const double tick = end - time_;
    failures_ = 0;
    while (true) {
        const double step = choose_step(end);
        const double time = step == end - time_ ? end : time_ + step;
        const Attempt outcome = attempt(time);
        if (outcome == Attempt::accepted) {
            return true;
        }
        if (!shrink(outcome, step, tick)) {
            return false;
        }
    }
}

// Never beyond the end, and never so close to it that a sliver is left.
double Stepper::choose_step(double end) const {
    const double left = end - time_;
    double step = step_;
    if (options_.fixed_step > 0 && failures_ == 0) {
        step = options_.fixed_step;
    }
    if (!(step < left)) {
        return left;
    }
    const double parts = std::ceil(left / step * (1 - 1e-9));
    return options_.fixed_step > 0 || parts < 3 ? left / parts : step;
}

Stepper::Attempt Stepper::attempt(double time) {
    predict(time);
    const Tolerances& tolerances = options_.tolerances;
    if (!newton_.solve(problem_, system_.bodies, tolerances.gravity, newton_share * tolerances.sum(), u_)) {
        return Attempt::newton_failed;
    }
    problem_.new_states(trial_states_);
    error_ = local_error(time, order_) / tolerances.sum();
    if (options_.fixed_step == 0 && !(error_ <= 1)) {
        return Attempt::error_too_large;
    }
    if (covered_ && !covered_(problem_.trial())) {
        return Attempt::not_covered;
    }
    const double error = error_;
    plan_next(time, error);
    commit(time);
    return Attempt::accepted;
}

// Sets the formulas of the step and u to the velocities that the past extrapolates to.
void Stepper::predict(double time) {
    if (options_.fixed_step > 0) {
        const bool grows = last_step_ > 0 && time - time_ > 2 * last_step_;
        order_ = grows ? 1 : std::min(options_.max_order, history_.count());
    }
    order_ = std::min(order_, history_.count());
    StepFormulas formulas;
    formulas.order = order_;
    BdfFormula own;
    for (std::size_t q = 1; q <= order_; ++q) {
        own = bdf_formula(time, history_.times(), q);
        formulas.past[q - 1] = own.past;
        formulas.friction_beta_h[q - 1] = own.beta_h;
    }
    formulas.beta_h = own.beta_h;
    history_.start(own, order_, starts_);
    problem_.begin(formulas, starts_);

    const std::size_t points = std::min(order_ + 1, history_.count());
    const auto weights = extrapolation(time, history_.times(), points);
    for (std::size_t b = 0; b < system_.bodies.size(); ++b) {
        const Body& body = system_.bodies[b];
        BodyState state = system_.states[b];
        for (std::size_t j = 1; j < points; ++j) {
            const BodyState& past = history_.states(j)[b];
            state.momentum += weights[j] * (past.momentum - system_.states[b].momentum);
            state.angular_momentum +=
                weights[j] * (past.angular_momentum - system_.states[b].angular_momentum);
        }
        u_.segment<3>(static_cast<Eigen::Index>(6 * b)) = velocity(body, state);
        u_.segment<3>(static_cast<Eigen::Index>(6 * b + 3)) = spin(body, state);
    }
}

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

void Stepper::commit(double time) {
    const auto results = problem_.results();
    for (std::size_t i = 0; i < results.size(); ++i) {
        ContactHistory& history = system_.contacts[i].history;
        if (results[i].law.state == ContactState::open) {
            history.clear();
            continue;
        }
        history.push(results[i].law.trial);
        history.centre_line = results[i].centre_line;
        statistics_.lost_directions += results[i].law.lost_direction;
        statistics_.centre_lines += results[i].centre_line;
    }
    system_.states.swap(trial_states_);
    history_.push(time, system_.states);
    last_step_ = time - time_;
    time_ = time;
    ++statistics_.accepted;
    ++statistics_.orders[problem_.formulas().order - 1];
    statistics_.smallest_step = std::min(statistics_.smallest_step, last_step_);
    statistics_.largest_step = std::max(statistics_.largest_step, last_step_);
    statistics_.time_stepped += last_step_;
}

// Order and step of the next step, after one of `error` at order_.
void Stepper::plan_next(double time, double error) {
    if (options_.fixed_step > 0) {
        return;
    }
    const double step = time - time_;
    ++held_;
    double best = gain(error, bias, order_);
    std::size_t order = order_;
    if (held_ > order_ || order_ == 1) {
        if (order_ > 1) {
            const double down =
                gain(local_error(time, order_ - 1) / options_.tolerances.sum(), bias, order_ - 1);
            if (down > best) {
                best = down, order = order_ - 1;
            }
        }
        if (order_ < options_.max_order && history_.count() >= order_ + 2) {
            const double up =
                gain(local_error(time, order_ + 1) / options_.tolerances.sum(), bias_up, order_ + 1);
            if (up > best) {
                best = up, order = order_ + 1;
            }
        }
    }
    best = std::min({best, most_growth[order - 1], newton_.effort() > hard ? easing : best});
    if (newton_.effort() > brisk) {
        best = std::min(best, 1.0);
    }
    if (best < 1) {
        step_ = step * std::max(best, most_shrink);
    } else if (held_ > order_ && (best >= least_gain || order != order_)) {
        step_ = step * best;
        held_ = 0;
    } else {
        step_ = std::max(step_, step);  // it may have been cut short by the tick's end
        order = order_;
    }
    order_ = order;
}

// After a failed attempt. False: there is no smaller step to try.
bool Stepper::shrink(Attempt why, double step, double tick) {
    if (why == Attempt::not_covered) {
        ++statistics_.rejected_contact;
        newton_.forget();
        return true;
    }
    ++failures_;
    held_ = 0;
    if (why == Attempt::newton_failed) {
        ++statistics_.rejected_newton;
        step_ = step * newton_shrink;
    } else {
        ++statistics_.rejected_error;
        step_ = step * std::clamp(gain(error_, bias, order_), most_shrink, 0.9);
    }
    if (failures_ >= most_failures) {
        order_ = 1;
    }
    return step_ > smallest_share * tick;
}

}  // namespace scree
