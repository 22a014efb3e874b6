#include <algorithm>
#include <cmath>

#include "nearest_feature.hpp"

namespace scree {

namespace {

using Flat = Eigen::Vector2d;  // distance from the axis and height

/// The half-plane through the axis and a point.
struct Meridian {
    Vec3 outward;   // unit, from the axis to the point
    Vec3 sideways;  // unit, across the half-plane
    double radius;  // of the point, from the axis

    explicit Meridian(const Vec3& point) : outward(point.x(), point.y(), 0), radius(outward.norm()) {
        outward = radius > 0 ? Vec3(outward / radius) : Vec3::UnitX();
        sideways = Vec3::UnitZ().cross(outward);
    }
    [[nodiscard]] Vec3 raised(const Flat& v) const { return v.x() * outward + v.y() * Vec3::UnitZ(); }
};

// A normal in the half-plane turns with the point round the axis, and about a corner within the half-plane.
NearestFeature feature(const Meridian& meridian, const Flat& normal, double height, double across,
                       double within) {
    const Vec3 along = meridian.raised({-normal.y(), normal.x()});
    NearestFeature nearest{meridian.raised(normal), height, Mat3::Zero()};
    nearest.normal_rate =
        across * meridian.sideways * meridian.sideways.transpose() + within * along * along.transpose();
    return nearest;
}

/// The half of a frustum's outline: two ends and the side between them.
struct Outline {
    Flat low, high;  // the rims
    Flat normal;     // of the side
    double length;   // of the side [m]

    explicit Outline(const Frustum& frustum)
        : low(frustum.bottom, -frustum.half_height), high(frustum.top, frustum.half_height) {
        length = (high - low).norm();
        normal = Flat(high.y() - low.y(), low.x() - high.x()) / length;
    }
    [[nodiscard]] double above_side(const Flat& point) const { return normal.dot(point - low); }
    /// The nearest point of the side, as a share of the way up.
    [[nodiscard]] double share(const Flat& point) const {
        return std::clamp((point - low).dot(high - low) / (length * length), 0.0, 1.0);
    }
};

NearestFeature on_side(const Outline& outline, const Meridian& meridian, const Flat& point) {
    const double across = meridian.radius > 0 ? outline.normal.x() / meridian.radius : 0;
    return feature(meridian, outline.normal, outline.above_side(point), across, 0);
}

NearestFeature on_end(const Meridian& meridian, const Flat& point, const Flat& rim) {
    const double up = rim.y() > 0 ? 1 : -1;
    return feature(meridian, {0, up}, up * (point.y() - rim.y()), 0, 0);
}

NearestFeature on_rim(const Meridian& meridian, const Flat& offset, double rim_radius) {
    const double distance = offset.norm();
    const double across = rim_radius > 0 ? offset.x() / distance / meridian.radius : 1 / distance;
    return feature(meridian, offset / distance, distance, across, 1 / distance);
}

NearestFeature highest(const NearestFeature& a, const NearestFeature& b) {
    return a.height >= b.height ? a : b;
}

}  // namespace

NearestFeature nearest_feature(const Frustum& frustum, const Vec3& point) {
    const Outline outline(frustum);
    const Meridian meridian(point);
    const Flat at(meridian.radius, point.z());
    for (const Flat& rim : {outline.low, outline.high}) {
        const bool over_end = rim.x() > 0 && at.x() <= rim.x();
        if (over_end && (rim.y() > 0 ? at.y() > rim.y() : at.y() < rim.y())) {
            return on_end(meridian, at, rim);
        }
    }
    const NearestFeature side = on_side(outline, meridian, at);
    const double share = outline.share(at);
    const Flat nearest = outline.low + share * (outline.high - outline.low);
    const bool beyond = share == 0 || share == 1;
    const bool outside = side.height > 0 || std::abs(at.y()) > frustum.half_height;
    if (outside && beyond && at != nearest) {
        return on_rim(meridian, at - nearest, nearest.x());
    }
    if (side.height > 0) {
        return side;
    }
    return highest(side, highest(on_end(meridian, at, outline.low), on_end(meridian, at, outline.high)));
}

NearestFeature nearest_feature(const Capsule& capsule, const Vec3& point) {
    const double height = std::clamp(point.z(), -capsule.half_length, capsule.half_length);
    const Vec3 offset = point - height * Vec3::UnitZ();
    const double distance = offset.norm();
    if (distance == 0) {
        return {Vec3::UnitX(), -capsule.radius, Mat3::Zero()};
    }
    NearestFeature nearest{offset / distance, distance - capsule.radius, Mat3::Zero()};
    Mat3 across = Mat3::Identity() - nearest.normal * nearest.normal.transpose();
    if (height == point.z()) {
        across -= Vec3::UnitZ() * Vec3::UnitZ().transpose();
    }
    nearest.normal_rate = across / distance;
    return nearest;
}

}  // namespace scree
