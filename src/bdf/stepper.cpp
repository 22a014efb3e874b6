#include <scree/bdf/stepper.hpp>

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double newton_share = 0.01;  // of the error tolerance, left to Newton's iteration
constexpr double first_share = 1e-3;   // of the time to fall or move by one's own radius

}  // namespace

void Stepper::restart(double time) {
    time_ = time;
    order_ = 1;
    held_ = 0;
    failures_ = 0;
    newton_.forget();
    for (Contact& contact : system_.contacts) {
        contact.history.age = std::min<std::size_t>(contact.history.age, 1);
    }
    evaluate_present(u_);
    first_force_ = problem_.forces();
    first_torque_ = problem_.torques();
    open_ledger();
    history_.restart(time, system_.states);
    const double first = first_step();
    step_ = step_ > 0 ? std::min(step_, first) : first;
}

double Stepper::first_step() const {
    const double gravity = options_.tolerances.gravity;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < system_.bodies.size(); ++b) {
        const Body& body = system_.bodies[b];
        if (!body.dynamic()) {
            continue;
        }
        const BodyState& state = system_.states[b];
        const double speed = velocity(body, state).norm() + spin(body, state).norm() * body.radius;
        if (gravity > 0) {
            least = std::min(least, std::sqrt(body.radius / gravity));
        }
        if (speed > 0) {
            least = std::min(least, body.radius / speed);
        }
    }
    return first_share * least;
}

bool Stepper::step(double end) {
    const double tick = end - time_;
    failures_ = 0;
    renewals_ = 0;
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
    formulas.time = time;
    formulas.step = time - time_;
    for (std::size_t q = 1; q <= order_; ++q) {
        formula_ = bdf_formula(time, history_.times(), q);
        formulas.past[q - 1] = formula_.past;
        formulas.friction_beta_h[q - 1] = formula_.beta_h;
    }
    formulas.beta_h = formula_.beta_h;
    history_.start(formula_, order_, starts_);
    start_momentum_.setZero();
    for (std::size_t b = 0; b < starts_.size(); ++b) {
        if (system_.bodies[b].dynamic()) {
            start_momentum_ += starts_[b].momentum;
        }
    }
    problem_.begin(formulas, starts_);

    const std::size_t points = std::min(order_ + 1, history_.count());
    const auto weights = extrapolation(time, history_.times(), points);
    for (std::size_t b = 0; b < system_.bodies.size(); ++b) {
        const Body& body = system_.bodies[b];
        BodyState state = system_.states[b];
        for (std::size_t j = 1; body.dynamic() && j < points; ++j) {
            const BodyState& past = history_.states(j)[b];
            state.momentum += weights[j] * (past.momentum - system_.states[b].momentum);
            state.angular_momentum +=
                weights[j] * (past.angular_momentum - system_.states[b].angular_momentum);
        }
        u_.segment<3>(static_cast<Eigen::Index>(6 * b)) = velocity(body, state);
        u_.segment<3>(static_cast<Eigen::Index>(6 * b + 3)) = spin(body, state);
    }
}

void Stepper::commit(double time) {
    accept(time, problem_.formulas().order, trial_states_);
    history_.push(time, system_.states);
    momentum_residual_ +=
        total_momentum(system_) - start_momentum_ - formula_.beta_h * outside_force(system_, problem_);
}

}  // namespace scree
