#pragma once

#include <array>

namespace scree {

/// A point and weight of the Gauss–Legendre formula with twelve points on [0, 1], exact for polynomials up to
/// degree 23 (Abramowitz and Stegun, table 25.4).
struct GaussPoint {
    double at, weight;
};

inline std::array<GaussPoint, 12> gauss_points() {
    constexpr double roots[] = {0.125233408511468915472441369464, 0.367831498998180193752691536644,
                                0.587317954286617447296702418941, 0.769902674194304687036893833213,
                                0.904117256370474856678465866119, 0.981560634246719250690549090149};
    constexpr double weights[] = {0.249147045813402785000562436043, 0.233492536538354808760849898925,
                                  0.203167426723065921749064455810, 0.160078328543346226334652529543,
                                  0.106939325995318430960254718194, 0.047175336386511827194615961485};
    std::array<GaussPoint, 12> points{};
    for (std::size_t i = 0; i < 6; ++i) {
        points[2 * i] = {0.5 * (1 - roots[i]), 0.5 * weights[i]};
        points[2 * i + 1] = {0.5 * (1 + roots[i]), 0.5 * weights[i]};
    }
    return points;
}

}  // namespace scree
