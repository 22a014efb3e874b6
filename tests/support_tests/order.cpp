#include <cmath>

#include <catch2/catch.hpp>

#include <tests/support/order.hpp>

TEST_CASE("The order estimator reads the order of the trapezoidal rule", "[support]") {
    std::vector<double> errors;
    for (int n = 8; n <= 64; n *= 2) {
        double sum = (1 + std::exp(1.0)) / 2;
        for (int i = 1; i < n; ++i) {
            sum += std::exp(static_cast<double>(i) / n);
        }
        errors.push_back(std::abs(sum / n - std::expm1(1.0)));
    }
    CHECK(scree::test::observed_order(errors) == Approx(2).epsilon(1e-3));
}
