#include <scree/dynamics/linear_solver.hpp>

namespace scree {

namespace {

constexpr int most_dense = 8;  // block rows, up to which a dense factorisation is as fast
constexpr double accuracy = 1e-6;
constexpr int most_iterations = 50;  // that cost as much as a complete factorisation

}  // namespace

bool LinearSolver::prepare(const BlockMatrix& matrix) {
    if (!matrix.all_finite()) {
        return false;
    }
    matrix.expand(matrix_);
    if (matrix.size() <= most_dense) {
        return prepare_dense();
    }
    if (!iteration_) {
        iteration_ = std::make_unique<Iteration>();
        iteration_->setTolerance(accuracy);
        iteration_->setMaxIterations(most_iterations);
    }
    if (!iteration_->preconditioner().eliminate(matrix)) {
        return prepare_complete();
    }
    iteration_->compute(matrix_);
    way_ = Way::iterative;
    return true;
}

bool LinearSolver::prepare_dense() {
    way_ = Way::dense;
    dense_.compute(matrix_.toDense());
    const auto pivots = dense_.matrixLU().diagonal();
    return pivots.allFinite() && (pivots.array() != 0).all();
}

bool LinearSolver::prepare_complete() {
    way_ = Way::complete;
    if (!complete_) {
        complete_ = std::make_unique<SparseFactors>();
        complete_->isSymmetric(true);
        complete_->setPivotThreshold(0.1);
    }
    complete_->compute(matrix_);
    return complete_->info() == Eigen::Success;
}

bool LinearSolver::solve(Eigen::VectorXd& x) {
    right_ = x;
    if (way_ == Way::iterative) {
        x = iteration_->solve(right_);
        if (iteration_->info() == Eigen::Success) {
            return true;
        }
        if (!prepare_complete()) {
            return false;
        }
    }
    if (way_ == Way::dense) {
        x = dense_.solve(right_);
    } else {
        x = complete_->solve(right_);
    }
    return x.allFinite();
}

}  // namespace scree
