#include <scree/bdf/corrector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

constexpr double softest = 0.04;             // stiffness number, hω of 0.2, up to which Newton is not needed
constexpr std::size_t most_iterations = 12;  // of the functional corrector
constexpr double linear_share = 0.01;        // what Newton's last step, quadratic, gains beyond its tolerance
constexpr double least_gain = 0.7;           // ratio of successive defects, above which it does not converge
constexpr std::size_t steps_of_newton = 20;  // after the functional corrector has failed

}  // namespace

Stiffness Stiffness::of(const StepProblem& problem, const System& system) {
    Stiffness most;
    for (std::size_t i = 0; i < problem.results().size(); ++i) {
        const ContactResult& result = problem.results()[i];
        if (result.law.state == ContactState::open) {
            continue;
        }
        const PairConstants& pair = system.contacts[i].pair;
        const double friction = pair.friction > 0 ? 1 : 0;
        const double stiffness = std::max(pair.elastic * result.area, friction * pair.tangential_stiffness);
        const double damping =
            std::max(pair.normal_damping * result.area, friction * pair.tangential_damping);
        most.frequency_squared = std::max(most.frequency_squared, stiffness / pair.reduced_mass);
        most.damping_rate = std::max(most.damping_rate, damping / pair.reduced_mass);
    }
    return most;
}

double Stiffness::number(double beta_h) const {
    return std::max(beta_h * beta_h * frequency_squared, beta_h * damping_rate);
}

bool Corrector::solve(StepProblem& problem, const System& system, double tolerance,
                      const Stiffness& stiffness, Persistence persistence, std::size_t& patience,
                      Eigen::VectorXd& u) {
    effort_ = 0;
    const bool free = system.contacts.empty();
    if (free || (patience == 0 && soft(problem.formulas().beta_h, stiffness))) {
        predicted_ = u;
        if (iterate(problem, system, tolerance, u)) {
            return true;
        }
        if (solver_ == Solver::fixed_point && !free) {
            return false;
        }
        patience = steps_of_newton;
        u = predicted_;
    }
    const bool solved = newton_.solve(problem, system.bodies, gravity_, tolerance, persistence, u);
    effort_ = newton_.effort();
    patience -= patience > 0 ? 1 : 0;
    return solved;
}

bool Corrector::soft(double beta_h, const Stiffness& stiffness) const {
    return solver_ == Solver::fixed_point ||
           (solver_ == Solver::automatic && stiffness.number(beta_h) <= softest);
}

// u := u − M⁻¹ R, M being the inertia: all but the forces' own change.
bool Corrector::iterate(StepProblem& problem, const System& system, double tolerance, Eigen::VectorXd& u) {
    double last = std::numeric_limits<double>::infinity();
    problem.evaluate(u, Detail::force);
    for (std::size_t i = 0; i < most_iterations; ++i) {
        const double defect = defect_norm(problem, system.bodies, gravity_);
        if (defect <= linear_share * solved_share * tolerance) {
            return true;
        }
        if (!(defect <= least_gain * last)) {
            return defect <= tolerance && at_rounding(problem, system.bodies, direction_);
        }
        last = defect;
        direction_ = -problem.residual();
        problem.solve_inertia(direction_);
        u += direction_;
        problem.evaluate(u, Detail::force);
        ++statistics_.functional_iterations;
    }
    return false;
}

NewtonStatistics Corrector::take_statistics() {
    NewtonStatistics sum = newton_.take_statistics();
    sum.functional_iterations = statistics_.functional_iterations;
    statistics_ = {};
    return sum;
}

}  // namespace scree
