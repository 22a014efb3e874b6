#pragma once

#include <span>
#include <utility>
#include <vector>

#include <scree/dynamics/contact.hpp>
#include <scree/dynamics/linear_solver.hpp>
#include <scree/dynamics/trial.hpp>

namespace scree {

/// dL/dω [kg m²] of a body at a trial step, whose inertia tensor turns with it.
Mat3 turning_inertia(const Body& body, const TrialBody& trial);

/// The matrix of Newton's method, d(residual)/d(velocities), in 6×6 blocks (v, ω) per dynamic body.
class Jacobian {
  public:
    /// Gathers the blocks at the last evaluation. Bodies and contacts as in StepProblem.
    void assemble(std::span<const Body> bodies, std::span<const TrialBody> trial,
                  std::span<const Contact> contacts, std::span<const ContactResult> results, double beta_h);

    /// Returns false when it is singular or not finite.
    bool factorize() { return solver_.prepare(matrix_); }

    /// x := J⁻¹ x, six numbers a body, those of fixed bodies set to zero. Returns false when there is no
    /// solution.
    bool solve(Eigen::VectorXd& x);

    /// J itself, six rows a body; for tests.
    [[nodiscard]] Eigen::MatrixXd dense() const;

  private:
    void number(std::span<const Body> bodies);
    void add_contact(const Contact& contact, const ContactResult& result, double beta_h);
    void add(int row, int column, const Mat6& block);

    BlockMatrix matrix_;
    LinearSolver solver_;
    std::vector<int> place_;  ///< by body, among the dynamic ones; −1: fixed
    /// By which rows are divided, so that all are velocities: mass, and mass times radius, by place.
    std::vector<std::pair<double, double>> scale_;
    Eigen::VectorXd part_;
};

}  // namespace scree
