#include <scree/dynamics/trial.hpp>

#include <algorithm>

namespace scree {

StepFormula StepFormulas::friction(std::size_t age) const {
    const std::size_t own = std::clamp(age, std::size_t{1}, order);
    return {std::span(past[own - 1]).first(own), friction_beta_h[own - 1]};
}

namespace {

void set_turns(const BodyStart& start, const StepFormulas& formulas, TrialBody& body) {
    for (std::size_t j = 0; j < formulas.order; ++j) {
        Quat turn = body.pose.orientation * start.past_orientations[j].conjugate();
        if (turn.w() < 0) {
            turn.coeffs() = -turn.coeffs();
        }
        body.turns[j] = turn;
    }
}

}  // namespace

void place(const BodyStart& start, const StepFormulas& formulas, TrialBody& body) {
    const double beta_h = formulas.beta_h;
    body.pose.position = start.position + beta_h * body.velocity;
    const Vec3 half = 0.5 * beta_h * body.spin;
    const Quat step(1, half.x(), half.y(), half.z());
    body.pose.orientation = (step * Quat(start.orientation)).normalized();
    body.turn_rate = beta_h / (1 + half.squaredNorm()) * (Mat3::Identity() + cross_matrix(half));
    set_turns(start, formulas, body);
}

void advance_prescribed(double step, BodyState& state) {
    state.position += step * state.momentum;
    const double speed = state.angular_momentum.norm();
    if (speed > 0) {
        const Quat turn(Eigen::AngleAxisd(step * speed, state.angular_momentum / speed));
        state.orientation = (turn * state.orientation).normalized();
    }
}

void place_prescribed(const BodyState& last, const BodyStart& start, const StepFormulas& formulas,
                      TrialBody& body) {
    BodyState state{last.position, last.orientation, body.velocity, body.spin};
    advance_prescribed(formulas.step, state);
    body.pose = {state.position, state.orientation};
    body.turn_rate = formulas.beta_h * Mat3::Identity();
    set_turns(start, formulas, body);
}

void place_on_path(const PrescribedPath& path, const BodyStart& start, const StepFormulas& formulas,
                   TrialBody& body) {
    const PathPoint point = path.at(formulas.time);
    body.pose = point.pose;
    body.velocity = point.velocity;
    body.spin = point.spin;
    body.surface_velocity = point.surface_velocity;
    body.turn_rate = formulas.beta_h * Mat3::Identity();
    set_turns(start, formulas, body);
}

}  // namespace scree
