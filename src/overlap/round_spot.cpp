#include <scree/overlap/round_spot.hpp>

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

// Cosine between a normal and that of a side, from which the point is on the side.
constexpr double on_side = 0.999;

struct RoundSpotOf {
    const Vec3& point;
    const Vec3& out;

    RoundSpot operator()(const Sphere& sphere) const { return {Vec3::Zero(), sphere.radius}; }
    RoundSpot operator()(const Capsule& capsule) const {
        const double height = (point - capsule.radius * out).z();
        return {{0, 0, std::clamp(height, -capsule.half_length, capsule.half_length)}, capsule.radius};
    }
    RoundSpot operator()(const Frustum& frustum) const {
        const double slope = 0.5 * (frustum.bottom - frustum.top) / frustum.half_height;
        const double steepness = std::hypot(1, slope);
        const double outward = out.head<2>().norm();
        if (outward + slope * out.z() < on_side * steepness) {
            return {point, 0};
        }
        const double radius = frustum.radius_at(point.z()) * steepness;
        return {{0, 0, point.z() - radius * out.z()}, radius};
    }
    template <class Flat>
    RoundSpot operator()(const Flat& /*shape*/) const {
        return {point, 0};
    }
};

}  // namespace

RoundSpot round_spot(const Shape& shape, const Vec3& point, const Vec3& out) {
    return std::visit(RoundSpotOf{point, out}, shape);
}

}  // namespace scree
