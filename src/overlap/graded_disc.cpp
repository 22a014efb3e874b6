#include "graded_disc.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace scree {

namespace {

using Point = Eigen::Vector2d;
using Triple = Eigen::Vector3d;

constexpr double first_angle = 1e-5;  // half the first side: flat up to a depth of 5·10⁻¹¹ radii
constexpr double growth = 1.4;        // of a corner's angle to the next one's
constexpr double widest = 0.12;       // side [rad]
constexpr double lift = 0.9 / 24;     // of a corner, by the squares of its sides: errors in area cancel
constexpr int refinements = 8;        // of Newton's method, which is at rounding after four

// Of the corners above the x axis.
std::vector<double> corner_angles() {
    std::vector<double> angles{first_angle};
    while ((growth - 1) * angles.back() < widest) {
        angles.push_back(growth * angles.back());
    }
    // The last side straddles the negative x axis.
    const double rest = std::numbers::pi - angles.back();
    const double sides = std::ceil(rest / widest - 0.5) + 0.5;
    const double start = angles.back();
    for (int i = 1; i < sides; ++i) {
        angles.push_back(start + i * rest / sides);
    }
    return angles;
}

std::vector<double> lifted_radii(const std::vector<double>& angles) {
    std::vector<double> radii;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double before = i > 0 ? angles[i] - angles[i - 1] : 2 * angles[i];
        const double after =
            i + 1 < angles.size() ? angles[i + 1] - angles[i] : 2 * (std::numbers::pi - angles[i]);
        radii.push_back(1 + lift * (before * before + after * after));
    }
    return radii;
}

// Moves corners in and out by three smooth functions of the angle, none of which touches the fine part.
std::vector<Point> corners(const std::vector<double>& angles, const std::vector<double>& radii,
                           const Triple& change) {
    std::vector<Point> upper;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double cosine = std::cos(angles[i]);
        const double smooth = change(0) + change(1) * cosine + change(2) * (2 * cosine * cosine - 1);
        const double radius = radii[i] + 0.5 * (1 - cosine) * smooth;
        upper.emplace_back(radius * cosine, radius * std::sin(angles[i]));
    }
    std::vector<Point> all;
    for (auto corner = upper.rbegin(); corner != upper.rend(); ++corner) {
        all.emplace_back(corner->x(), -corner->y());
    }
    all.insert(all.end(), upper.begin(), upper.end());
    return all;
}

// What the whole polygon must not have: area beyond the circle's, a first moment, unequal second moments.
Triple defects(const std::vector<Point>& polygon) {
    Triple sum(-std::numbers::pi, 0, 0);
    Point from = polygon.back();
    for (const Point& to : polygon) {
        const double twice = from.x() * to.y() - to.x() * from.y();
        const auto square = [](double p, double q) { return p * p + p * q + q * q; };
        sum += twice * Triple(1.0 / 2, (from.x() + to.x()) / 6,
                              (square(from.x(), to.x()) - square(from.y(), to.y())) / 12);
        from = to;
    }
    return sum;
}

std::vector<Point> make_disc() {
    const std::vector<double> angles = corner_angles();
    const std::vector<double> radii = lifted_radii(angles);
    const auto defects_of = [&](const Triple& change) { return defects(corners(angles, radii, change)); };
    Triple change = Triple::Zero();
    for (int i = 0; i < refinements; ++i) {
        constexpr double step = 1e-4;
        Eigen::Matrix3d rates;
        for (int j = 0; j < 3; ++j) {
            const Triple aside = step * Triple::Unit(j);
            rates.col(j) = (defects_of(change + aside) - defects_of(change - aside)) / (2 * step);
        }
        change -= rates.partialPivLu().solve(defects_of(change));
    }
    return corners(angles, radii, change);
}

}  // namespace

const std::vector<Point>& graded_disc() {
    static const std::vector<Point> disc = make_disc();
    return disc;
}

}  // namespace scree
