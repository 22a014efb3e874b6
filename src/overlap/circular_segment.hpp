#pragma once

#include <algorithm>
#include <cmath>

namespace scree {

/// The part x ≥ start of a disc about the origin: its area and moments.
struct CircularSegment {
    double half_angle;  ///< [rad], of its arc
    double area;        ///< [m²]
    double first;       ///< ∫ x dA [m³]
    double along;       ///< ∫ x² dA [m⁴]
    double across;      ///< ∫ y² dA [m⁴]

    CircularSegment(double radius, double start) {
        const double cosine = radius > 0 ? std::clamp(start / radius, -1.0, 1.0) : 1;
        half_angle = std::acos(cosine);
        const double sine = std::sin(half_angle);
        const double cube = sine * sine * sine;
        const double square = radius * radius;
        const double share = half_angle - sine * cosine;
        area = square * share;
        first = 2.0 / 3.0 * square * radius * cube;
        along = 0.25 * square * square * (share + 2 * cube * cosine);
        across = square * square / 12 * (3 * share - 2 * cube * cosine);
    }
};

}  // namespace scree
