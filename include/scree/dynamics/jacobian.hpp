#pragma once

#include <memory>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <scree/dynamics/islands.hpp>
#include <scree/dynamics/trial.hpp>

namespace scree {

/// What stands for a restraint's held spin in the equations of a step: a moment of inertia [kg m²] of the
/// body's size.
double held_inertia(const Body& body);

/// The part of the equations' derivative by (v, ω) that is not the contacts': d(p, L)/d(v, ω), the inertia
/// tensor turning with the body, and what its restraint does.
Mat6 inertia_block(const Body& body, const TrialBody& trial, double beta_h);

/// The matrix of Newton's method, d(residual)/d(velocities), in 6×6 blocks (v, ω) per dynamic body, kept and
/// factorised island by island: dense for a few bodies, sparse above.
class Jacobian {
  public:
    /// Gathers the blocks at the last evaluation. Bodies and contacts as in StepProblem.
    void assemble(std::span<const Body> bodies, std::span<const TrialBody> trial,
                  std::span<const Contact> contacts, std::span<const ContactResult> results, double beta_h);

    /// Returns false when a block of the factorisation is singular or not finite.
    bool factorize();

    /// x := J⁻¹ x, six numbers a body, those of fixed bodies set to zero. By parts that touch nothing too.
    void solve(Eigen::VectorXd& x) const;

    /// J x, by the assembled blocks; for tests.
    [[nodiscard]] Eigen::MatrixXd dense(std::size_t bodies) const;

    [[nodiscard]] const Islands& islands() const { return islands_; }

  private:
    struct Block {
        int row, column;  ///< bodies
        Mat6 value;
    };
    /// Minimum degree on the pattern of A + Aᵀ: the pattern is symmetric, and that order fills in least.
    using SparseSolver = Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::AMDOrdering<int>>;
    struct IslandSolver {
        bool sparse = false;
        Eigen::PartialPivLU<Eigen::MatrixXd> dense_lu;
        Eigen::SparseMatrix<double> matrix;
        std::unique_ptr<SparseSolver> sparse_lu;
        std::vector<int> pattern;  ///< that the symbolic analysis belongs to
    };

    void add_contact(const Contact& contact, const ContactResult& result, std::span<const Body> bodies,
                     double beta_h);
    bool factorize_dense(IslandSolver& solver, std::size_t island);
    bool factorize_sparse(IslandSolver& solver, std::size_t island);

    Islands islands_;
    std::vector<Block> blocks_;                   ///< off the diagonal, two a touching pair of dynamic bodies
    std::vector<Mat6> diagonal_;                  ///< one a body
    std::vector<std::vector<std::size_t>> held_;  ///< numbers of the blocks of each island
    std::vector<IslandSolver> solvers_;
    mutable Eigen::VectorXd part_;
};

}  // namespace scree
