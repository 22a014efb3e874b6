#pragma once

#include <memory>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <scree/dynamics/block_incomplete_lu.hpp>
#include <scree/dynamics/block_matrix.hpp>

namespace scree {

/// Solves A x = b for matrices of 6×6 blocks: dense for a few bodies; for more by BiCGSTAB with an incomplete
/// factorisation, which costs a tenth of a complete one, or by a complete one should that not converge.
class LinearSolver {
  public:
    /// Takes over a matrix. Returns false when it is singular or not finite.
    bool prepare(const BlockMatrix& matrix);

    /// x := A⁻¹ x, to rounding by a complete factorisation, otherwise to a relative residual of 1e-6. Returns
    /// false when that cannot be had.
    bool solve(Eigen::VectorXd& x);

  private:
    /// Minimum degree on the pattern of A + Aᵀ: the pattern is symmetric, and that order fills in least.
    using SparseFactors = Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::AMDOrdering<int>>;
    using Iteration = Eigen::BiCGSTAB<Eigen::SparseMatrix<double>, BlockIncompleteLU>;
    enum class Way { dense, iterative, complete };

    bool prepare_dense();
    bool prepare_complete();

    Way way_ = Way::dense;
    Eigen::SparseMatrix<double> matrix_;
    Eigen::PartialPivLU<Eigen::MatrixXd> dense_;
    std::unique_ptr<Iteration> iteration_;
    std::unique_ptr<SparseFactors> complete_;
    Eigen::VectorXd right_;
};

}  // namespace scree
