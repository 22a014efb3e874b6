#include <cmath>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <tests/support/finite_difference.hpp>

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST_CASE("The finite-difference checker passes a right Jacobian and shows the size of a mistake",
          "[support]") {
    const scree::test::VectorFunction f = [](const VectorXd& x) {
        return VectorXd{{std::sin(x(0)) * x(1), std::exp(x(1)) + x(0)}};
    };
    const VectorXd x{{0.3, 0.7}};
    MatrixXd jacobian{{std::cos(x(0)) * x(1), std::sin(x(0))}, {1, std::exp(x(1))}};
    CHECK(scree::test::jacobian_error(f, x, jacobian) < 1e-9);

    jacobian(0, 0) += 1e-4 * jacobian.maxCoeff();
    CHECK(scree::test::jacobian_error(f, x, jacobian) == Approx(1e-4).epsilon(1e-3));
}
