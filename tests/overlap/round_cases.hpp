#pragma once

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <tests/overlap/rate_error.hpp>

namespace scree::test::round_cases {

constexpr double pi = std::numbers::pi;
constexpr double radius = 0.1;
constexpr double half = 0.15;  ///< height or length
inline const Pose askew{{0.4, -0.3, 1.2}, turned(0.8, {1, -2, 1})};
inline const Quat lying = turned(pi / 2, {1, 0, 0});
inline const Quat cone_lying = turned(pi / 2 + std::atan(radius / (2 * half)), {1, 0, 0});

inline Frustum cylinder() {
    return make_frustum(radius, radius, half);
}
inline Frustum cone() {
    return make_frustum(radius, 0, half);
}
inline Capsule capsule() {
    return make_capsule(radius, half);
}

/// A shape turned and then sunk into the ground by a depth, all of it moved to an odd place.
inline Placed sunk(const Shape& shape, const Quat& turn, double depth) {
    const double lowest = reach_along(shape, turn.conjugate() * -Vec3::UnitZ());
    return moved(placed(shape, {0.02, 0.01, lowest - depth}, turn), askew);
}
inline Placed floor() {
    return moved(ground(), askew);
}
inline Placed table() {
    return moved(placed(make_box({1, 1, 0.5}), {0, 0, -0.25}), askew);
}

/// Area of the part of a disc that a line at a distance from its centre cuts off.
inline double segment(double disc, double distance) {
    return disc * disc * std::acos(distance / disc) -
           distance * std::sqrt((disc - distance) * (disc + distance));
}

}  // namespace scree::test::round_cases
