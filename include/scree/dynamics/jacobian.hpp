#pragma once

#include <span>
#include <utility>
#include <vector>

#include <scree/dynamics/contact.hpp>
#include <scree/dynamics/linear_solver.hpp>
#include <scree/dynamics/trial.hpp>

namespace scree {

/// What stands for a restraint's held spin in the equations of a step: a moment of inertia [kg m²] of the
/// body's size.
double held_inertia(const Body& body);

/// The part of the equations' derivative by (v, ω) that is not the contacts': d(p, L)/d(v, ω), the inertia
/// tensor turning with the body, and what its restraint does.
Mat6 inertia_block(const Body& body, const TrialBody& trial, double beta_h);

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
    void add_force(int row, int column, Mat6 block);
    void add(int row, int column, const Mat6& block);

    BlockMatrix matrix_;
    LinearSolver solver_;
    std::vector<int> place_;  ///< by body, among the dynamic ones; −1: fixed
    /// By which rows are divided, so that all are velocities: mass, and mass times radius, by place.
    std::vector<std::pair<double, double>> scale_;
    std::vector<const Restraint*> restraint_;  ///< of the same
    Eigen::VectorXd part_;
};

}  // namespace scree
