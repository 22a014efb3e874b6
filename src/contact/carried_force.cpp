#include <scree/contact/carried_force.hpp>

#include <cmath>

namespace scree {

namespace {

constexpr double least_projection = 1e-6;  // of a length, below which a projection has no direction left

// v × M, column by column.
Mat39 cross(const Vec3& v, const Mat39& m) {
    return cross_matrix(v) * m;
}

// Derivative of turn_about(normal, rotation), the rotation turned further by `turn`.
Row9 turn_about_rate(const Vec3& normal, const Quat& rotation, const Mat39& normal_rate, const Mat39& turn) {
    const double w = rotation.w();
    const Vec3 v = rotation.vec();
    const double along = v.dot(normal);
    const Vec3 by_turn = w * (w * normal + v.cross(normal)) + along * v;
    return (by_turn.transpose() * turn + 2 * w * v.transpose() * normal_rate) / (w * w + along * along);
}

}  // namespace

double turn_about(const Vec3& axis, const Quat& rotation) {
    return 2 * std::atan2(rotation.vec().dot(axis), rotation.w());
}

CarriedForce carry(const FrictionRecord& record, const Vec3& n, const Quat& turn_a, const Quat& turn_b,
                   bool co_rotation, const MotionRates* rates) {
    CarriedForce carried;
    const double torsion = record.force.dot(record.normal);
    const Vec3 stored = record.force - torsion * record.normal;
    const double size = stored.norm();
    const Vec3 projected = stored - stored.dot(n) * n;
    const double left = projected.norm();
    carried.force = torsion * n;
    if (rates != nullptr) {
        carried.rate = torsion * rates->normal;
    }
    carried.lost_direction = size > 0 && left <= least_projection * size;
    if (size == 0 || carried.lost_direction) {
        return carried;
    }

    const double stretch = size / left;
    const Vec3 rescaled = stretch * projected;
    const double angle = co_rotation ? 0.5 * (turn_about(n, turn_a) + turn_about(n, turn_b)) : 0;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const Vec3 sideways = n.cross(rescaled);
    carried.force += cosine * rescaled + sine * sideways;
    if (rates == nullptr) {
        return carried;
    }

    const Vec3 direction = projected / left;
    Mat39 rescaled_rate = -n * (stored.transpose() * rates->normal) - stored.dot(n) * rates->normal;
    rescaled_rate = stretch * (rescaled_rate - direction * (direction.transpose() * rescaled_rate)).eval();
    carried.rate += cosine * rescaled_rate;
    carried.rate += sine * (cross(n, rescaled_rate) - cross(rescaled, rates->normal));
    if (co_rotation) {
        const Row9 angle_rate = 0.5 * (turn_about_rate(n, turn_a, rates->normal, rates->turn_a) +
                                       turn_about_rate(n, turn_b, rates->normal, rates->turn_b));
        carried.rate += (cosine * sideways - sine * rescaled) * angle_rate;
    }
    return carried;
}

CarriedForce carry_in_plane(const FrictionRecord& record, const Vec3& n, const MotionRates* rates) {
    CarriedForce carried;
    const double torsion = record.force.dot(record.normal);
    const double along = record.force.dot(plane_tangent(record.normal));
    const Vec3 tangent = plane_tangent(n);
    carried.force = torsion * n + along * tangent;
    carried.lost_direction = along != 0 && tangent.isZero(0);
    if (rates != nullptr) {
        carried.rate = torsion * rates->normal + along * plane_tangent_rate(n, rates->normal);
    }
    return carried;
}

Vec3 plane_tangent(const Vec3& n) {
    const double length = std::hypot(n.z(), n.x());
    return length > least_projection ? Vec3(n.z() / length, 0, -n.x() / length) : Vec3::Zero();
}

Mat39 plane_tangent_rate(const Vec3& n, const Mat39& normal_rate) {
    const Vec3 tangent = plane_tangent(n);
    if (tangent.isZero(0)) {
        return Mat39::Zero();
    }
    // A unit vector in the plane changes across itself alone, along t × e_y, the part of n in that plane.
    const Vec3 in_plane = tangent.cross(Vec3::UnitY());
    const Row9 turning = in_plane.transpose() * cross(Vec3::UnitY(), normal_rate);
    return in_plane * turning / std::hypot(n.z(), n.x());
}

}  // namespace scree
