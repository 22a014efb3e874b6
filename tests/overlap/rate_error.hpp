#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include <tests/support/finite_difference.hpp>
#include <tests/support/overlaps.hpp>

namespace scree::test {

/// What two placed bodies share, the centroid in world coordinates.
using Meeting = std::function<ContactGeometry(const Placed&, const Placed&)>;

inline ContactGeometry overlap_of_shapes(const Placed& a, const Placed& b) {
    return overlap_of(a, b).value();
}

/// The error of a closed-form rate of one value by a motion ξ of A about the centroid. Steps are shares of
/// the overlap's `depth` and `width` [m]. Errors are shares of the largest entry or, where all vanish (the
/// normal of a corner in a face), of `least`: a row with ξ itself stands in for it.
template <class Value>
double rate_error(const Placed& a, const Placed& b, const Value& value, const Eigen::MatrixXd& rate,
                  double depth, double width, double least, const Meeting& meet = overlap_of_shapes) {
    const Vec3 about = meet(a, b).centroid;
    const auto f = [&](const Eigen::VectorXd& xi) -> Eigen::VectorXd {
        Eigen::VectorXd row(rate.rows() + 1);
        row << value(meet(moved(a, about, xi), b)), least / depth * xi(0);
        return row;
    };
    Eigen::VectorXd scale(6);
    scale << Vec3::Constant(depth), Vec3::Constant(depth / width);
    Eigen::MatrixXd with_least = Eigen::MatrixXd::Zero(rate.rows() + 1, 6);
    with_least.topRows(rate.rows()) = rate;
    with_least(rate.rows(), 0) = least / depth;
    return jacobian_error(f, Eigen::VectorXd::Zero(6), with_least, scale);
}

/// The errors in V, c, S, ∫ r×n_A dA and n.
struct DerivativeErrors {
    double volume, centroid, area_vector, area_moment, normal;

    [[nodiscard]] double largest() const {
        return std::max({volume, centroid, area_vector, area_moment, normal});
    }
};

inline DerivativeErrors derivative_errors(const Placed& a, const Placed& b, double depth, double width,
                                          const Meeting& meet = overlap_of_shapes) {
    const ContactGeometry g = meet(a, b);
    const auto error_of = [&](const auto& value, const Eigen::MatrixXd& rate, double least) {
        return rate_error(a, b, value, rate, depth, width, least, meet);
    };
    Eigen::MatrixXd volume_rate(1, 6), centroid_rate(3, 6);
    volume_rate << g.area_vector.transpose(), g.area_moment().transpose();
    centroid_rate << g.first_moment / g.volume, g.second_moment / g.volume;
    const auto moment = [&](const ContactGeometry& now) -> Eigen::VectorXd {
        return now.area_moment() + (now.centroid - g.centroid).cross(now.area_vector);  // about c as it was
    };
    const auto volume = [](const ContactGeometry& now) { return Eigen::VectorXd::Constant(1, now.volume); };
    const auto centroid = [](const ContactGeometry& now) { return now.centroid; };
    const auto area_vector = [](const ContactGeometry& now) { return now.area_vector; };
    const auto normal = [](const ContactGeometry& now) { return now.normal; };
    return {error_of(volume, volume_rate, 0), error_of(centroid, centroid_rate, 0),
            error_of(area_vector, g.boundary.topRows<3>(), g.area * depth / width),
            error_of(moment, g.boundary.bottomRows<3>(), g.area * depth),
            error_of(normal, g.normal_rate, depth / width)};
}

/// The largest of them.
inline double derivative_error(const Placed& a, const Placed& b, double depth, double width,
                               const Meeting& meet = overlap_of_shapes) {
    return derivative_errors(a, b, depth, width, meet).largest();
}

}  // namespace scree::test
