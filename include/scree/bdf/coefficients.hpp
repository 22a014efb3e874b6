#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace scree {

/// A backward differentiation formula with variable step, y_{n+1} = Σ past[j] y_{n−j} + beta_h ẏ_{n+1}: the
/// derivative at t_{n+1} of the polynomial through the new value and `order` past ones (Hairer, Nørsett and
/// Wanner, Solving ODEs I, III.5).
struct BdfFormula {
    std::array<double, 5> past{};  ///< of the latest value first; 0 beyond the order
    double beta_h = 0;             ///< [s]
};

/// `past_times`: t_n, t_{n−1}, …, at least `order` of them, descending and all before `time`.
BdfFormula bdf_formula(double time, std::span<const double> past_times, std::size_t order);

/// Weights of the polynomial through `points` past values, evaluated at `time`: y ≈ Σ w[j] y_{n−j}.
std::array<double, 6> extrapolation(double time, std::span<const double> past_times, std::size_t points);

/// The local error of the formula of an order q, as weights of the new value and q + 1 past ones: what the
/// formula leaves of the polynomial's next term, ‖βh Π_{j≤q}(t_{n+1} − t_{n+1−j})‖ times the divided
/// difference of order q + 1.
std::array<double, 7> error_weights(double time, std::span<const double> past_times, std::size_t order);

}  // namespace scree
