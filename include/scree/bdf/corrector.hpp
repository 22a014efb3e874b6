#pragma once

#include <scree/bdf/newton.hpp>
#include <scree/bdf/options.hpp>

namespace scree {

/// How fast the contacts that have a force answer, at most.
struct Stiffness {
    double frequency_squared = 0;  ///< k/M [1/s²], k of (Y/Lc)‖S‖ and of the tangential spring the stiffer
    double damping_rate = 0;       ///< c/M [1/s] of the two dampings

    /// Of the problem's last evaluation.
    static Stiffness of(const StepProblem& problem, const System& system);
    /// About the factor by which an iteration of the functional corrector shrinks its error, at βh [s].
    [[nodiscard]] double number(double beta_h) const;
};
void visit_state(auto& with, StateOf<Stiffness> auto& stiffness) {
    auto& [frequency_squared, damping_rate] = stiffness;
    with(frequency_squared, damping_rate);
}

/// Solves the equations of an implicit step, by the functional iteration where the forces are soft at the
/// present step, by Newton's method where they are not.
class Corrector {
  public:
    /// Of the options' solver; their gravity scales errors.
    explicit Corrector(const SteppingOptions& options)
        : solver_(options.solver), gravity_(options.tolerances.gravity) {}

    /// Advances u from its predicted value to the solution; the problem is left evaluated there. `tolerance`
    /// is in the units of ErrorScale::norm. `stiffness` is that of the last accepted step, `patience` the
    /// steps to come for which the functional iteration is out of question. Returns false when it does not
    /// converge: the step must not be accepted.
    bool solve(StepProblem& problem, const System& system, double tolerance, const Stiffness& stiffness,
               Persistence persistence, std::size_t& patience, Eigen::VectorXd& u);

    /// What was kept from earlier steps belongs to something else from here on.
    void forget() { newton_.forget(); }

    /// Newton iterations that the last solve took.
    [[nodiscard]] std::size_t effort() const { return effort_; }
    /// Hands over the counts and starts them at zero.
    NewtonStatistics take_statistics();

  private:
    [[nodiscard]] bool soft(double beta_h, const Stiffness& stiffness) const;
    bool iterate(StepProblem& problem, const System& system, double tolerance, Eigen::VectorXd& u);

    Solver solver_;
    double gravity_;
    Newton newton_;
    NewtonStatistics statistics_;
    std::size_t effort_ = 0;
    Eigen::VectorXd predicted_, direction_;
};

}  // namespace scree
