#include "parts.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

// A motion about one point as the motion about another, `arm` [m] from it.
Mat6 motion_at(const Vec3& arm) {
    Mat6 moved = Mat6::Identity();
    moved.topRightCorner<3, 3>() = -cross_matrix(arm);
    return moved;
}

void add_part(const ContactGeometry& part, ContactGeometry& whole) {
    const Vec3 arm = part.centroid - whole.centroid;
    const Mat6 moved = motion_at(arm);
    whole.second_moment += part.second_moment - part.first_moment * cross_matrix(arm) +
                           arm * part.area_moment().transpose() -
                           arm * part.area_vector.transpose() * cross_matrix(arm);
    whole.first_moment += part.first_moment + arm * part.area_vector.transpose();
    whole.boundary += moved.transpose() * part.boundary * moved;
    whole.depth = std::max(whole.depth, part.depth);
    whole.flat_patch = whole.flat_patch || part.flat_patch;
    const Vec3 aside = arm - arm.dot(whole.normal) * whole.normal;
    whole.lever += part.area * std::hypot(part.lever, aside.norm());
}

}  // namespace

ContactGeometry whole_of(std::span<const ContactGeometry> parts, const Vec3& apart, bool was_centre_line) {
    ContactGeometry whole;
    whole.depth_moment = 0;
    double surface = 0;
    double patch = 0;
    for (const ContactGeometry& part : parts) {
        whole.volume += part.volume;
        whole.centroid += part.volume * part.centroid;
        whole.area_vector += part.area_vector;
        const bool potential = whole.depth_moment >= 0 && part.depth_moment >= 0;
        whole.depth_moment = potential ? whole.depth_moment + part.depth_moment : -1;
        patch += part.area;
        surface += 2 * part.area;
    }
    whole.centroid /= whole.volume;
    whole.normal = -whole.area_vector.stableNormalized();
    for (const ContactGeometry& part : parts) {
        add_part(part, whole);
    }
    set_normal(whole, surface, apart, -whole.centroid, was_centre_line);
    whole.flat_patch = whole.flat_patch && !whole.centre_line;
    whole.lever = whole.centre_line || patch == 0 ? 0 : whole.lever / patch;
    return whole;
}

void scale(ContactGeometry& g, double share) {
    g.volume *= share;
    g.area_vector *= share;
    g.area *= share;
    g.first_moment *= share;
    g.second_moment *= share;
    g.boundary *= share;
    g.depth_moment = g.depth_moment >= 0 ? share * g.depth_moment : -1;
}

// Seen by who moves with the plane, A makes the rest of its motion; then all is turned with the plane.
void follow_tangent(const Mat3& normal_rate, const Vec3& point, double height, ContactGeometry& g) {
    if (normal_rate.isZero()) {
        return;
    }
    Mat36 turn;  // of the plane, about B's nearest point
    turn << normal_rate, -normal_rate * cross_matrix(point - g.centroid);
    turn = (cross_matrix(g.normal) * turn).eval();
    const Mat36 moved = cross_matrix(g.centroid - (point - height * g.normal)) * turn;
    Mat6 rest = Mat6::Identity();
    rest.topRows<3>() += moved;
    rest.bottomRows<3>() -= turn;

    Mat36 centroid;
    centroid << g.first_moment, g.second_moment;
    centroid = (centroid * rest - g.volume * moved).eval();
    // ∫ r×n_A dA stays what it was: it is the antisymmetric part.
    const Mat3 change = centroid.leftCols<3>() - g.first_moment;
    g.boundary = (g.boundary * rest).eval();
    g.boundary.topRows<3>() -= cross_matrix(g.area_vector) * turn;
    g.boundary.bottomRows<3>() -= cross_matrix(g.area_moment()) * turn - cross_matrix(g.area_vector) * moved;
    g.first_moment += 0.5 * (change + change.transpose());
    g.second_moment = centroid.rightCols<3>();
    g.normal_rate = -cross_matrix(g.normal) * turn;
}

}  // namespace scree
