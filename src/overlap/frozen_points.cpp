#include <scree/overlap/frozen_points.hpp>

#include <algorithm>
#include <stdexcept>

namespace scree {

namespace {

/// A point that is sunk in; world axes, origin at A's.
struct Sunk {
    Vec3 on_a, normal;
    double depth;

    /// The middle of its prism.
    [[nodiscard]] Vec3 middle() const { return on_a + 0.5 * depth * normal; }
};

struct SunkPoints {
    std::array<Sunk, FrozenPoints::most> all;
    std::size_t count = 0;

    [[nodiscard]] std::span<const Sunk> touching() const { return std::span(all).first(count); }
};

SunkPoints sunk_points(std::span<const FrozenPoint> points, const Pose& pose_a, const Pose& pose_b) {
    const Mat3 turn_a = pose_a.orientation.toRotationMatrix();
    const Mat3 turn_b = pose_b.orientation.toRotationMatrix();
    const Vec3 apart = pose_b.position - pose_a.position;
    SunkPoints sunk;
    for (const FrozenPoint& point : points) {
        const Vec3 on_a = turn_a * point.on_a;
        const Vec3 normal = turn_b * point.normal;
        const double depth = normal.dot(turn_b * point.on_b + apart - on_a);
        if (depth > 0) {
            sunk.all[sunk.count++] = {on_a, normal, depth};
        }
    }
    return sunk;
}

// V, c and S, and what follows from them. `share` is the area of one point [m²].
void sum_prisms(std::span<const Sunk> sunk, double share, ContactGeometry& g) {
    double depths = 0;
    double squares = 0;
    Vec3 weighted = Vec3::Zero();
    for (const Sunk& point : sunk) {
        depths += point.depth;
        squares += point.depth * point.depth;
        weighted += point.depth * point.middle();
        g.area_vector -= share * point.normal;
        g.depth = std::max(g.depth, point.depth);
    }
    g.volume = share * depths;
    g.centroid = weighted / depths;
    g.depth_moment = 0.5 * share * squares;
}

// A's motion moves a point of A by da = u + θ × (a − c), its depth by −n·da and its prism's middle by the
// rest of da and half of what goes along n.
void add_rates(std::span<const Sunk> sunk, double share, ContactGeometry& g) {
    for (const Sunk& point : sunk) {
        const Mat3 arm = cross_matrix(point.on_a - g.centroid);
        const Mat3 along = point.normal * point.normal.transpose();
        const Vec3 off = point.middle() - g.centroid;
        const Mat3 moved =
            share * (point.depth * (Mat3::Identity() - 0.5 * along) - off * point.normal.transpose());
        g.first_moment += moved;
        g.second_moment -= moved * arm;
        const Mat3 turned = share * cross_matrix(point.normal);
        g.boundary.bottomLeftCorner<3, 3>() += turned;
        g.boundary.bottomRightCorner<3, 3>() -= turned * arm;
    }
}

double mean_distance(std::span<const Sunk> sunk, const ContactGeometry& g) {
    double sum = 0;
    for (const Sunk& point : sunk) {
        const Vec3 off = point.middle() - g.centroid;
        sum += (off - off.dot(g.normal) * g.normal).norm();
    }
    return sum / static_cast<double>(sunk.size());
}

}  // namespace

void FrozenPoints::freeze(std::span<const FrozenPoint> points) {
    if (points.size() > most) {
        throw std::invalid_argument("more points than a contact can have");
    }
    std::copy(points.begin(), points.end(), points_.begin());
    count_ = points.size();
}

bool FrozenPoints::geometry(const Pose& pose_a, const Pose& pose_b, Detail /*detail*/, bool was_centre_line,
                            OverlapWorkspace& /*workspace*/, ContactGeometry& g) const {
    const SunkPoints found = sunk_points(points(), pose_a, pose_b);
    const std::span<const Sunk> sunk = found.touching();
    if (sunk.empty()) {
        return false;
    }
    const double share = area_ / static_cast<double>(count_);
    g = ContactGeometry{};
    sum_prisms(sunk, share, g);
    add_rates(sunk, share, g);
    const double surface = 2 * share * static_cast<double>(sunk.size());
    set_normal(g, surface, pose_a.position - pose_b.position, -g.centroid, was_centre_line);
    g.flat_patch = sunk.size() > 1 && !g.centre_line;
    g.lever = g.centre_line ? 0 : mean_distance(sunk, g);
    return true;
}

}  // namespace scree
