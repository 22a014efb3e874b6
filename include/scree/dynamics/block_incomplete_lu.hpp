#pragma once

#include <vector>

#include <Eigen/Dense>

#include <scree/dynamics/block_matrix.hpp>

namespace scree {

/// An approximate factorisation of a block matrix without fill-in, ILU(0), as a preconditioner for Eigen's
/// iterative solvers (Saad, Iterative Methods for Sparse Linear Systems, 10.3). It is exact where the blocks
/// form a tree that is numbered from its leaves or along a chain, as a tower of bodies does.
class BlockIncompleteLU {
  public:
    /// Returns false when a pivot block is singular or not finite.
    bool eliminate(const BlockMatrix& matrix);

    /// What Eigen asks of a preconditioner; the factors are those of the last eliminate().
    template <class Matrix>
    BlockIncompleteLU& compute(const Matrix& /*matrix*/) {
        return *this;
    }
    /// Likewise nothing to do.
    template <class Matrix>
    BlockIncompleteLU& analyzePattern(const Matrix& /*matrix*/) {
        return *this;
    }
    /// Likewise nothing to do.
    template <class Matrix>
    BlockIncompleteLU& factorize(const Matrix& /*matrix*/) {
        return *this;
    }
    /// Eigen asks; what fails is told by eliminate().
    [[nodiscard]] static Eigen::ComputationInfo info() { return Eigen::Success; }
    /// U⁻¹ L⁻¹ `right`, six numbers a block row.
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  private:
    using Vec6 = Eigen::Matrix<double, 6, 1>;

    void eliminate_row(int row);

    BlockMatrix factors_;             ///< L below the diagonal, U above it
    std::vector<Mat6> inverse_;       ///< of U's diagonal blocks
    std::vector<std::size_t> where_;  ///< by column: place in the row at hand, or none
};

}  // namespace scree
