#include <scree/bdf/explicit_stepper.hpp>

#include <cmath>

namespace scree {

namespace {

// With the inertia as it lies in the middle of the step: at its beginning the turn of a free body would be of
// first order.
Vec3 middle_spin(const Body& body, const BodyState& state, double step) {
    Vec3 now = spin(body, state);
    const bool held = body.restraint != nullptr && body.restraint->holds_spin();
    if (held || !body.dynamic()) {
        return now;
    }
    const Vec3 quarter = 0.25 * step * now;
    BodyState middle = state;
    middle.orientation = (Quat(1, quarter.x(), quarter.y(), quarter.z()) * state.orientation).normalized();
    return spin(body, middle);
}

}  // namespace

void ExplicitStepper::restart(double time) {
    memory_.time = time;
    for (Contact& contact : system_.contacts) {
        contact.history.shorten();
    }
    evaluate_present(u_);
    remember_energies();
}

void ExplicitStepper::resume(const SteppingMemory& memory) {
    memory_ = memory;
    if (!memory_.powers || memory_.force.size() != system_.bodies.size()) {
        evaluate_present(u_);
    }
}

StepOutcome ExplicitStepper::step(double end) {
    const double left = end - memory_.time;
    const double parts = std::ceil(left / options_.fixed_step * (1 - 1e-9));
    const double time = parts <= 1 ? end : memory_.time + left / parts;
    const double step = time - memory_.time;
    const bool verlet = options_.method == Method::velocity_verlet;

    states_ = system_.states;
    kick(verlet ? 0.5 * step : step, states_);
    hold_spins(step, states_);
    drift(time, states_);
    if (covered_ && !covered_(problem_.trial())) {
        ++statistics_.rejected_contact;
        return StepOutcome::left_cover;
    }
    memory_.force = problem_.forces();
    memory_.torque = problem_.torques();
    if (verlet) {
        kick(0.5 * step, states_);
    }
    for (std::size_t b = 0; b < states_.size(); ++b) {
        states_[b].position = problem_.trial()[b].pose.position;
        states_[b].orientation = problem_.trial()[b].pose.orientation;
        if (!system_.bodies[b].dynamic()) {
            states_[b].momentum = problem_.trial()[b].velocity;
            states_[b].angular_momentum = problem_.trial()[b].spin;
        }
    }
    hold_spins(step, states_);
    if (!finite(states_)) {
        return StepOutcome::failed;
    }
    accept(time, verlet ? 2 : 1, states_);
    return StepOutcome::accepted;
}

void ExplicitStepper::kick(double duration, std::vector<BodyState>& states) const {
    for (std::size_t b = 0; b < states.size(); ++b) {
        if (!system_.bodies[b].dynamic()) {
            continue;
        }
        states[b].momentum += duration * memory_.force[b];
        states[b].angular_momentum += duration * memory_.torque[b];
    }
}

void ExplicitStepper::hold_spins(double duration, std::vector<BodyState>& states) const {
    for (std::size_t b = 0; b < states.size(); ++b) {
        const Body& body = system_.bodies[b];
        if (body.restraint == nullptr || !body.restraint->holds_spin()) {
            continue;
        }
        const Vec3 held = spin_after(*body.restraint, spin(body, system_.states[b]), duration);
        BodyState& state = states[b];
        state.angular_momentum = restrained_momentum(*body.restraint, state.angular_momentum,
                                                     world_inertia(body, state.orientation), held);
    }
}

void ExplicitStepper::drift(double time, const std::vector<BodyState>& states) {
    const double step = time - memory_.time;
    StepFormulas formulas;
    formulas.time = time;
    formulas.step = step;
    formulas.beta_h = step;
    formulas.past[0][0] = 1;
    formulas.friction_beta_h[0] = step;
    starts_.resize(states.size());
    u_.resize(static_cast<Eigen::Index>(6 * states.size()));
    for (std::size_t b = 0; b < states.size(); ++b) {
        const BodyState& old = system_.states[b];
        starts_[b].position = old.position;
        starts_[b].orientation = old.orientation.coeffs();
        starts_[b].past_orientations[0] = old.orientation;
        u_.segment<3>(static_cast<Eigen::Index>(6 * b)) = velocity(system_.bodies[b], states[b]);
        u_.segment<3>(static_cast<Eigen::Index>(6 * b + 3)) = middle_spin(system_.bodies[b], states[b], step);
    }
    problem_.begin(formulas, starts_);
    problem_.evaluate(u_, Detail::force);
}

bool ExplicitStepper::finite(const std::vector<BodyState>& states) const {
    for (const BodyState& state : states) {
        if (!state.position.allFinite() || !state.momentum.allFinite() ||
            !state.angular_momentum.allFinite()) {
            return false;
        }
    }
    return true;
}

}  // namespace scree
