#pragma once

#include <scree/bdf/error_norm.hpp>
#include <scree/bdf/statistics.hpp>
#include <scree/dynamics/step_problem.hpp>

namespace scree {

/// Share of the tolerance that a solved step's equations may be off: a friction force that lags must not add
/// up to a creep.
constexpr double solved_share = 1e-3;

/// The largest over the dynamic bodies of the residual as the velocities that it leaves unexplained, in the
/// units of ErrorScale::norm. It bounds the error of u, which the stiffness divides, and the error of the
/// momenta, which take the forces as they are. Not a number when a residual is not.
double defect_norm(const StepProblem& problem, std::span<const Body> bodies, double gravity);

/// Whether a change of u moves the bodies by no more than the rounding of their positions.
bool at_rounding(const StepProblem& problem, std::span<const Body> bodies, const Eigen::VectorXd& change);

/// How much work a step is worth.
enum class Persistence {
    brief,     ///< give up early: a smaller step is easier
    thorough,  ///< do all that can be done
};

/// Solves the equations of one implicit step by Newton's method with a kept factorisation, a search along the
/// direction for the zero of R·du when full steps do not converge, and continuation in the capped tangential
/// stiffness when that fails too.
class Newton {
  public:
    /// Advances u from its predicted value to the solution; the problem is left evaluated there. `tolerance`
    /// is in the units of ErrorScale::norm. Returns false, u being what it was, when it does not converge:
    /// the step must not be accepted.
    bool solve(StepProblem& problem, std::span<const Body> bodies, double gravity, double tolerance,
               Persistence persistence, Eigen::VectorXd& u);

    /// The kept factorisation belongs to something else from here on.
    void forget() { factorized_ = false; }

    /// Iterations that the last solve took.
    [[nodiscard]] std::size_t effort() const { return effort_; }
    /// Hands over the counts and starts them at zero.
    NewtonStatistics take_statistics() { return std::exchange(statistics_, {}); }

  private:
    enum class Outcome { converged, failed };

    Outcome iterate(StepProblem& problem, std::span<const Body> bodies, double gravity, double tolerance,
                    Eigen::VectorXd& u);
    bool refresh(StepProblem& problem, const Eigen::VectorXd& u);
    [[nodiscard]] bool stale(const StepProblem& problem) const;
    double search(StepProblem& problem, const Eigen::VectorXd& u, const Eigen::VectorXd& direction);

    NewtonStatistics statistics_;
    Persistence persistence_ = Persistence::thorough;
    std::size_t effort_ = 0;
    bool factorized_ = false;
    double factorized_beta_h_ = 0;
    std::size_t age_ = 0;  ///< solves since the factorisation
    Eigen::VectorXd predicted_, direction_, trial_;
};

}  // namespace scree
