#pragma once

#include <tests/support/step_case.hpp>

namespace scree::test {

/// Moves a system without friction by the classical Runge–Kutta method, contact forces taken at the states
/// themselves: a reference that shares nothing with the implicit step but the forces.
class ExplicitMotion {
  public:
    ExplicitMotion(StepCase& step, ContactForces& forces) : step_(step), problem_(step.system, forces) {}

    void advance(double h) {
        const std::vector<BodyState> start = step_.system.states;
        std::vector<BodyState> sum = start;
        const double share[] = {h / 6, h / 3, h / 3, h / 6};
        const double ahead[] = {h / 2, h / 2, h, 0};
        for (int stage = 0; stage < 4; ++stage) {
            evaluate();
            std::vector<BodyState> next = start;
            for (std::size_t b = 0; b < start.size(); ++b) {
                add_rates(b, share[stage], sum[b]);
                add_rates(b, ahead[stage], next[b]);
            }
            step_.system.states = next;
        }
        for (BodyState& state : sum) {
            state.orientation.normalize();
        }
        step_.system.states = sum;
    }

    /// Forces at the present states.
    const StepProblem& evaluate() {
        for (std::size_t b = 0; b < step_.system.bodies.size(); ++b) {
            const Body& body = step_.system.bodies[b];
            BodyState& state = step_.system.states[b];
            state.orientation.normalize();
            step_.u.segment<6>(static_cast<Eigen::Index>(6 * b)) << velocity(body, state), spin(body, state);
        }
        step_.begin(problem_, 0, 1, Detail::force);
        return problem_;
    }

  private:
    // The states' rates at the last evaluation.
    void add_rates(std::size_t b, double h, BodyState& to) const {
        const TrialBody& now = problem_.trial()[b];
        to.position += h * now.velocity;
        const Quat turning(0, now.spin.x(), now.spin.y(), now.spin.z());
        to.orientation.coeffs() += 0.5 * h * (turning * now.pose.orientation).coeffs();
        if (step_.system.bodies[b].dynamic()) {
            to.momentum += h * problem_.forces()[b];
            to.angular_momentum += h * problem_.torques()[b];
        }
    }

    StepCase& step_;
    StepProblem problem_;
};

}  // namespace scree::test
