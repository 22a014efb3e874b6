#pragma once

#include <scree/bdf/error_norm.hpp>

namespace scree {

struct NewtonStatistics {
    std::size_t iterations = 0;
    std::size_t jacobians = 0;
    std::size_t factorizations = 0;
};

/// Solves the equations of one implicit step by Newton's method with a kept factorisation, a search along the
/// direction for the zero of R·du when full steps do not converge, and continuation in the capped tangential
/// stiffness when that fails too.
class Newton {
  public:
    /// Advances u from its predicted value to the solution; the problem is left evaluated there. `tolerance`
    /// is in the units of ErrorScale::norm. Returns false when it does not converge: the step must not be
    /// accepted.
    bool solve(StepProblem& problem, std::span<const Body> bodies, double gravity, double tolerance,
               Eigen::VectorXd& u);

    /// The kept factorisation belongs to something else from here on.
    void forget() { factorized_ = false; }

    /// Iterations that the last solve took.
    [[nodiscard]] std::size_t effort() const { return effort_; }
    [[nodiscard]] const NewtonStatistics& statistics() const { return statistics_; }

  private:
    enum class Outcome { converged, failed };

    Outcome iterate(StepProblem& problem, std::span<const Body> bodies, double gravity, double tolerance,
                    std::size_t most, Eigen::VectorXd& u);
    bool refresh(StepProblem& problem, const Eigen::VectorXd& u);
    bool stale(const StepProblem& problem) const;
    double search(StepProblem& problem, const Eigen::VectorXd& u, const Eigen::VectorXd& direction);
    static double defect_norm(const StepProblem& problem, std::span<const Body> bodies, double gravity);

    NewtonStatistics statistics_;
    std::size_t effort_ = 0;
    bool factorized_ = false;
    double factorized_beta_h_ = 0;
    std::size_t age_ = 0;  ///< solves since the factorisation
    Eigen::VectorXd direction_, trial_;
};

}  // namespace scree
