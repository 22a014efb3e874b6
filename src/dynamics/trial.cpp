#include <scree/dynamics/trial.hpp>

#include <algorithm>

namespace scree {

StepFormula StepFormulas::friction(std::size_t age) const {
    const std::size_t own = std::clamp(age, std::size_t{1}, order);
    return {std::span(past[own - 1]).first(own), friction_beta_h[own - 1]};
}

void place(const BodyStart& start, const StepFormulas& formulas, TrialBody& body) {
    const double beta_h = formulas.beta_h;
    body.pose.position = start.position + beta_h * body.velocity;
    const Vec3 half = 0.5 * beta_h * body.spin;
    const Quat step(1, half.x(), half.y(), half.z());
    body.pose.orientation = (step * Quat(start.orientation)).normalized();
    body.turn_rate = beta_h / (1 + half.squaredNorm()) * (Mat3::Identity() + cross_matrix(half));
    for (std::size_t j = 0; j < formulas.order; ++j) {
        Quat turn = body.pose.orientation * start.past_orientations[j].conjugate();
        if (turn.w() < 0) {
            turn.coeffs() = -turn.coeffs();
        }
        body.turns[j] = turn;
    }
}

}  // namespace scree
