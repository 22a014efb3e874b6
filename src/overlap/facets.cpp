#include "facets.hpp"

#include <algorithm>

namespace scree {

namespace {

// Where the direction is along the axis within this angle, it gives no azimuth: a solid that stands on its
// end is tilted by more when it begins to touch with a part of the end only.
constexpr double least_tilt = 1e-7;

// The height that is nearest to an end and yet inside by half the end's radius, or half a height; of an end
// with less than half the largest radius, where that radius is reached.
double inner_height(const Frustum& frustum, double own, double other) {
    const double inside = frustum.half_height - 0.5 * std::min(own, frustum.half_height);
    if (own >= 0.5 * other) {
        return inside;
    }
    const double reached = (0.5 * other - own) / (other - own);  // of the way from the small end
    return std::min(inside, frustum.half_height * (1 - 2 * reached));
}

}  // namespace

Facing facing(const Vec3& direction, const Quat& other) {
    return {other * -direction, other * direction.unitOrthogonal()};
}

FacetPose facet_pose(const Pose& pose, const Facing& facing) {
    FacetPose facets;
    const Vec3 axis = pose.orientation * Vec3::UnitZ();
    const auto across = [&](const Vec3& v) -> Vec3 { return v - v.dot(axis) * axis; };
    // Squared twice, so that from a larger tilt nothing is taken away.
    const double ratio = across(facing.toward).squaredNorm() / (least_tilt * least_tilt);
    const Vec3 toward = facing.toward + least_tilt / (1 + ratio * ratio) * facing.otherwise;
    const double size = across(toward).norm();
    const Vec3 ahead = size > 0 ? across(across(toward) / size).normalized() : axis.unitOrthogonal();
    Mat3 frame;
    frame << ahead, axis.cross(ahead), axis;
    facets.pose = {pose.position, Quat(frame)};
    facets.axis = axis;
    facets.spin = axis.transpose();
    if (size > 0) {
        facets.spin -= toward.dot(axis) / size * ahead.transpose();
    }
    return facets;
}

void follow_facets(const FacetPose& facets, ContactGeometry& g) {
    const Vec3 sideways = facets.axis.cross(g.centroid);  // how a spin of the facets moves the centroid
    const auto of_spin = [&](const auto& by_motion, const auto& by_turn) {
        return (by_motion * sideways + by_turn * facets.axis).eval();
    };
    g.second_moment -= of_spin(g.first_moment, g.second_moment) * facets.spin;
    g.boundary.rightCols<3>() -= of_spin(g.boundary.leftCols<3>(), g.boundary.rightCols<3>()) * facets.spin;
    g.normal_rate.rightCols<3>() -=
        of_spin(g.normal_rate.leftCols<3>(), g.normal_rate.rightCols<3>()) * facets.spin;
    g.tilting = without(facets.axis);
}

Mat3 without(const Vec3& axis) {
    return Mat3::Identity() - axis * axis.transpose();
}

Faceted faceted(const Frustum& frustum) {
    return {frustum.facets,
            {{0, 0, -inner_height(frustum, frustum.bottom, frustum.top)},
             {0, 0, inner_height(frustum, frustum.top, frustum.bottom)}}};
}

Faceted faceted(const Capsule& capsule) {
    return {capsule.side, {{0, 0, -capsule.half_length}, {0, 0, capsule.half_length}}};
}

}  // namespace scree
