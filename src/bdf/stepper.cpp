#include <scree/bdf/stepper.hpp>

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double solver_share = 0.01;  // of the error tolerance, left to the solution of the equations
constexpr double solver_share_of_fixed = 1e-4;       // where the tolerance does not choose the step
constexpr double first_share = 1e-3;                 // of the time to fall or move by one's own radius
constexpr std::size_t failures_before_thorough = 4;  // of a step, with less work each

}  // namespace

void Stepper::restart(double time) {
    start_afresh(time, 0);
    remember_energies();
}

// With the forces as they are a `moment` [s] later.
void Stepper::start_afresh(double time, double moment) {
    const double planned = memory_.next_step;
    memory_ = {};
    memory_.time = time;
    for (Contact& contact : system_.contacts) {
        contact.history.shorten();
    }
    evaluate_present(u_, moment);
    memory_.past.restart(time, system_.states);
    const double first = options_.fixed_step > 0 ? options_.fixed_step : first_step();
    memory_.next_step = planned > 0 ? std::min(planned, first) : first;
    corrector_.forget();
}

void Stepper::resume(const SteppingMemory& memory) {
    memory_ = memory;
    if (!memory_.powers || memory_.past.count() == 1) {
        evaluate_present(u_);
    }
    corrector_.forget();
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

StepOutcome Stepper::step(double end) {
    const double tick = end - memory_.time;
    failures_ = landings_ = 0;
    landing_ = 0;
    while (true) {
        const double step = landing_ > 0 ? landing_ - memory_.time : choose_step(end);
        const double time = step == end - memory_.time ? end : memory_.time + step;
        const Attempt outcome = attempt(time);
        if (outcome == Attempt::accepted) {
            if (landing_ > 0) {
                start_afresh(time, moment());
            }
            return StepOutcome::accepted;
        }
        if (outcome == Attempt::not_covered) {
            ++statistics_.rejected_contact;
            return StepOutcome::left_cover;
        }
        landing_ = 0;
        const bool located = outcome == Attempt::error_too_large && locate_onset(time);
        if (!located && !shrink(outcome, step, tick)) {
            return StepOutcome::failed;
        }
    }
}

Stepper::Attempt Stepper::attempt(double time) {
    predict(time);
    const double share = options_.fixed_step > 0 ? solver_share_of_fixed : solver_share;
    const double allowed = share * allowed_error(memory_.order);
    const bool last_resort = options_.fixed_step > 0 || failures_ >= failures_before_thorough;
    const bool solved =
        corrector_.solve(problem_, system_, allowed, memory_.stiffness,
                         last_resort ? Persistence::thorough : Persistence::brief, memory_.patience, u_);
    statistics_.newton.add(corrector_.take_statistics());
    if (!solved) {
        return Attempt::not_solved;
    }
    problem_.new_states(trial_states_);
    error_ = local_error(time, memory_.order);
    if (options_.fixed_step == 0 && !(error_ <= 1)) {
        return Attempt::error_too_large;
    }
    if (covered_ && !covered_(problem_.trial())) {
        return Attempt::not_covered;
    }
    plan_next(time, error_);
    commit(time);
    return Attempt::accepted;
}

// Sets the formulas of the step and u to the velocities that the past extrapolates to.
void Stepper::predict(double time) {
    const StateHistory& past = memory_.past;
    if (options_.fixed_step > 0) {
        const bool grows = memory_.last_step > 0 && time - memory_.time > 2 * memory_.last_step;
        memory_.order = grows ? 1 : std::min(options_.max_order, past.count());
    }
    memory_.order = std::min(memory_.order, past.count());
    StepFormulas formulas;
    formulas.order = memory_.order;
    formulas.time = time;
    formulas.step = time - memory_.time;
    for (std::size_t q = 1; q <= memory_.order; ++q) {
        formula_ = bdf_formula(time, past.times(), q);
        formulas.past[q - 1] = formula_.past;
        formulas.friction_beta_h[q - 1] = formula_.beta_h;
    }
    formulas.beta_h = formula_.beta_h;
    past.start(formula_, memory_.order, starts_);
    start_momentum_.setZero();
    for (std::size_t b = 0; b < starts_.size(); ++b) {
        if (system_.bodies[b].dynamic()) {
            start_momentum_ += starts_[b].momentum;
        }
    }
    problem_.begin(formulas, starts_);

    const std::size_t points = std::min(memory_.order + 1, past.count());
    const auto weights = extrapolation(time, past.times(), points);
    u_.resize(static_cast<Eigen::Index>(6 * system_.bodies.size()));
    for (std::size_t b = 0; b < system_.bodies.size(); ++b) {
        const Body& body = system_.bodies[b];
        BodyState state = system_.states[b];
        for (std::size_t j = 1; body.dynamic() && j < points; ++j) {
            const BodyState& earlier = past.states(j)[b];
            state.momentum += weights[j] * (earlier.momentum - system_.states[b].momentum);
            state.angular_momentum +=
                weights[j] * (earlier.angular_momentum - system_.states[b].angular_momentum);
        }
        u_.segment<3>(static_cast<Eigen::Index>(6 * b)) = velocity(body, state);
        u_.segment<3>(static_cast<Eigen::Index>(6 * b + 3)) = spin(body, state);
    }
}

void Stepper::commit(double time) {
    accept(time, problem_.formulas().order, trial_states_);
    memory_.past.push(time, system_.states);
    flows_.momentum_gain +=
        total_momentum(system_) - start_momentum_ - formula_.beta_h * outside_force(system_, problem_);
}

}  // namespace scree
