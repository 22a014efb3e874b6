#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace scree::test {

/// The order of convergence: the slope of log error over log step, by least squares, where each error was
/// made with a step `ratio` times smaller than the one before it.
inline double observed_order(const std::vector<double>& errors, double ratio = 2) {
    const auto n = static_cast<double>(errors.size());
    const double middle = (n - 1) / 2;
    double covariance = 0;
    double variance = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double offset = static_cast<double>(i) - middle;
        covariance += offset * std::log(errors[i]);
        variance += offset * offset;
    }
    return -covariance / variance / std::log(ratio);
}

}  // namespace scree::test
