#pragma once

#include <algorithm>
#include <functional>
#include <limits>

#include <Eigen/Core>

namespace scree::test {

using VectorFunction = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// The Jacobian of f at x by central differences; variable i moves by step · scale(i) to either side.
inline Eigen::MatrixXd difference_jacobian(const VectorFunction& f, const Eigen::VectorXd& x,
                                           const Eigen::VectorXd& scale, double step) {
    Eigen::MatrixXd jacobian(f(x).size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Eigen::VectorXd ahead = x;
        Eigen::VectorXd behind = x;
        ahead(i) += step * scale(i);
        behind(i) -= step * scale(i);
        // The step that was taken, which rounding makes differ from the one asked for.
        jacobian.col(i) = (f(ahead) - f(behind)) / (ahead(i) - behind(i));
    }
    return jacobian;
}

/// The smallest error, over the steps 1e-2, 1e-3, … 1e-9, of a closed-form Jacobian against central
/// differences: the largest entry of the deviation over the largest entry of the Jacobian, columns times
/// `scale` (the variables' typical sizes) and rows over `row_scale` (the values' typical sizes). A right
/// Jacobian of a smooth function gives some 1e-9, a wrong one about the size of its mistake.
inline double jacobian_error(const VectorFunction& f, const Eigen::VectorXd& x,
                             const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& scale,
                             const Eigen::VectorXd& row_scale) {
    const Eigen::VectorXd rows = row_scale.cwiseInverse();
    const auto largest = [&](const Eigen::MatrixXd& m) {
        return (rows.asDiagonal() * m * scale.asDiagonal()).eval().cwiseAbs().maxCoeff();
    };
    const double size = std::max(largest(jacobian), std::numeric_limits<double>::min());
    double error = std::numeric_limits<double>::infinity();
    for (double step = 1e-2; step > 0.5e-9; step /= 10) {
        error = std::min(error, largest(difference_jacobian(f, x, scale, step) - jacobian) / size);
    }
    return error;
}

inline double jacobian_error(const VectorFunction& f, const Eigen::VectorXd& x,
                             const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& scale) {
    return jacobian_error(f, x, jacobian, scale, Eigen::VectorXd::Ones(jacobian.rows()));
}

inline double jacobian_error(const VectorFunction& f, const Eigen::VectorXd& x,
                             const Eigen::MatrixXd& jacobian) {
    return jacobian_error(f, x, jacobian, Eigen::VectorXd::Ones(x.size()));
}

}  // namespace scree::test
