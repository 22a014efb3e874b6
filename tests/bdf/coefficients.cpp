#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/bdf/coefficients.hpp>

using namespace scree;

namespace {

// Past times at uneven steps, the latest first; the new time is 1.
const std::vector<double> past{0.91, 0.78, 0.71, 0.55, 0.47, 0.31};
constexpr double now = 1;

double power(double t, std::size_t degree) {
    return std::pow(t - 0.3, static_cast<double>(degree));
}
double slope(double t, std::size_t degree) {
    return degree == 0 ? 0 : static_cast<double>(degree) * power(t, degree - 1);
}

// y_{n+1} by the formula, from exact past values and the exact derivative.
double advanced(std::size_t order, std::size_t degree) {
    const BdfFormula formula = bdf_formula(now, past, order);
    double y = formula.beta_h * slope(now, degree);
    for (std::size_t j = 0; j < order; ++j) {
        y += formula.past[j] * power(past[j], degree);
    }
    return y;
}

}  // namespace

TEST_CASE("A formula of order q reproduces polynomials of degree q with variable steps, and fails on q + 1",
          "[bdf]") {
    for (std::size_t order = 1; order <= 5; ++order) {
        for (std::size_t degree = 0; degree <= order; ++degree) {
            CAPTURE(order, degree);
            // Rounding, magnified by coefficients up to a few hundred.
            CHECK(std::abs(advanced(order, degree) - power(now, degree)) < 1e-13);
        }
        CHECK(std::abs(advanced(order, order + 1) - power(now, order + 1)) > 1e-7);
    }
}

TEST_CASE("At equal steps the formulas are the textbook ones", "[bdf]") {
    const std::vector<double> even{0.9, 0.8, 0.7};
    const BdfFormula second = bdf_formula(1, even, 2);
    CHECK(second.past[0] == Approx(4.0 / 3).epsilon(1e-12));
    CHECK(second.past[1] == Approx(-1.0 / 3).epsilon(1e-12));
    CHECK(second.beta_h == Approx(0.2 / 3).epsilon(1e-12));
    const BdfFormula third = bdf_formula(1, even, 3);
    CHECK(third.past[0] == Approx(18.0 / 11).epsilon(1e-12));
    CHECK(third.beta_h == Approx(0.6 / 11).epsilon(1e-12));
}

TEST_CASE("The extrapolation through k values is exact to degree k − 1 and no further", "[bdf]") {
    for (std::size_t points = 1; points <= 6; ++points) {
        const auto weights = extrapolation(now, past, points);
        for (std::size_t degree = 0; degree <= points; ++degree) {
            double y = 0;
            for (std::size_t j = 0; j < points; ++j) {
                y += weights[j] * power(past[j], degree);
            }
            const double error = std::abs(y - power(now, degree));
            CAPTURE(points, degree);
            CHECK((degree < points ? error < 1e-12 : error > 1e-7));
        }
    }
}

TEST_CASE("The error weights give what the formula leaves of the next power, exactly", "[bdf]") {
    for (std::size_t order = 1; order <= 5; ++order) {
        const auto weights = error_weights(now, past, order);
        const auto estimate = [&](std::size_t degree) {
            double sum = weights[0] * power(now, degree);
            for (std::size_t k = 1; k <= order + 1; ++k) {
                sum += weights[k] * power(past[k - 1], degree);
            }
            return sum;
        };
        CAPTURE(order);
        for (std::size_t degree = 0; degree <= order; ++degree) {
            CHECK(std::abs(estimate(degree)) < 1e-12);
        }
        const double left = std::abs(advanced(order, order + 1) - power(now, order + 1));
        CHECK(std::abs(estimate(order + 1)) == Approx(left).epsilon(1e-6));
    }
}
