#include <scree/bdf/stepper.hpp>

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double newton_share = 0.01;  // of the error tolerance, left to Newton's iteration
constexpr double first_share = 1e-3;   // of the time to fall or move by one's own radius

}  // namespace

Stepper::Stepper(System& system, ContactForces& forces, const SteppingOptions& options)
    : system_(system), options_(options), problem_(system, forces) {}

void Stepper::restart(double time) {
    time_ = time;
    order_ = 1;
    held_ = 0;
    failures_ = 0;
    newton_.forget();
    history_.restart(time, system_.states, sums_);
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
    open_ledger();
    const double first = first_share * least;
    step_ = step_ > 0 ? std::min(step_, first) : first;
}

// What was changed from outside between the last step and now counts as work and impulse from outside.
void Stepper::open_ledger() {
    const double held = energy_ledger(system_, problem_.results(), sums_, 0).held();
    const Vec3 momentum = total_momentum(system_);
    if (started_) {
        sums_.applied += held - held_last_;
        sums_.impulse += momentum - momentum_last_;
    } else {
        held_at_start_ = held;
        momentum_at_start_ = momentum;
    }
    started_ = true;
    history_.restart(time_, system_.states, sums_);
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
    for (std::size_t q = 1; q <= order_; ++q) {
        formula_ = bdf_formula(time, history_.times(), q);
        formulas.past[q - 1] = formula_.past;
        formulas.friction_beta_h[q - 1] = formula_.beta_h;
    }
    formulas.beta_h = formula_.beta_h;
    history_.start(formula_, order_, starts_);
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
    sums_ = history_.start_sums(formula_, problem_.formulas().order);
    sums_.add(formula_.beta_h, accumulation_rates(system_, problem_));
    system_.states.swap(trial_states_);
    history_.push(time, system_.states, sums_);
    held_last_ = energy_ledger(system_, results, sums_, 0).held();
    momentum_last_ = total_momentum(system_);
    last_step_ = time - time_;
    time_ = time;
    ++statistics_.accepted;
    ++statistics_.orders[problem_.formulas().order - 1];
    statistics_.smallest_step = std::min(statistics_.smallest_step, last_step_);
    statistics_.largest_step = std::max(statistics_.largest_step, last_step_);
    statistics_.time_stepped += last_step_;
}

}  // namespace scree
