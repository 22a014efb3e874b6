#include <scree/bdf/coefficients.hpp>

namespace scree {

// With s_j = t_{n+1} − t_{n−j}, the derivative at t_{n+1} of the polynomial through the new value y and the
// past ones is y Σ 1/s_j − Σ_j (y_{n−j}/s_j) Π_{i≠j} s_i/(s_i − s_j).
BdfFormula bdf_formula(double time, std::span<const double> past_times, std::size_t order) {
    BdfFormula formula;
    double own = 0;
    for (std::size_t j = 0; j < order; ++j) {
        const double step = time - past_times[j];
        double weight = 1 / step;
        own += weight;
        for (std::size_t i = 0; i < order; ++i) {
            if (i != j) {
                weight *= (time - past_times[i]) / (past_times[j] - past_times[i]);
            }
        }
        formula.past[j] = weight;
    }
    formula.beta_h = 1 / own;
    for (std::size_t j = 0; j < order; ++j) {
        formula.past[j] /= own;
    }
    return formula;
}

std::array<double, 6> extrapolation(double time, std::span<const double> past_times, std::size_t points) {
    std::array<double, 6> weights{};
    for (std::size_t j = 0; j < points; ++j) {
        double weight = 1;
        for (std::size_t i = 0; i < points; ++i) {
            if (i != j) {
                weight *= (time - past_times[i]) / (past_times[j] - past_times[i]);
            }
        }
        weights[j] = weight;
    }
    return weights;
}

std::array<double, 7> error_weights(double time, std::span<const double> past_times, std::size_t order) {
    double scale = bdf_formula(time, past_times, order).beta_h;
    for (std::size_t j = 0; j < order; ++j) {
        scale *= time - past_times[j];
    }
    std::array<double, 7> weights{};
    const auto moment = [&](std::size_t k) { return k == 0 ? time : past_times[k - 1]; };
    for (std::size_t k = 0; k <= order + 1; ++k) {
        double weight = scale;
        for (std::size_t i = 0; i <= order + 1; ++i) {
            if (i != k) {
                weight /= moment(k) - moment(i);
            }
        }
        weights[k] = weight;
    }
    return weights;
}

}  // namespace scree
