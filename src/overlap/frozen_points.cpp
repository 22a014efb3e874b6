#include <scree/overlap/frozen_points.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace scree {

namespace {

/// A point that is sunk in; world axes, origin at A's.
struct Sunk {
    Vec3 on_a, normal;
    double depth;
    double radius_a;
    bool round;        // one of the surfaces is
    Mat3 normal_rate;  // by the motion of on_a

    /// The middle of its prism.
    [[nodiscard]] Vec3 middle() const { return on_a + (0.5 * depth - radius_a) * normal; }
    /// How that follows the motion of on_a.
    [[nodiscard]] Mat3 middle_rate() const {
        return Mat3::Identity() - 0.5 * normal * normal.transpose() + (0.5 * depth - radius_a) * normal_rate;
    }
};

struct SunkPoints {
    std::array<Sunk, FrozenPoints::most> all;
    std::size_t count = 0;

    [[nodiscard]] std::span<const Sunk> touching() const { return std::span(all).first(count); }
};

// `apart` leads from B's point to A's.
Sunk against_plane(const FrozenPoint& point, const Vec3& on_a, const Vec3& apart, const Vec3& normal) {
    const double depth = point.radius_a + point.radius_b - point.slack - normal.dot(apart);
    const bool round = point.radius_a > 0 || point.radius_b > 0;
    return {on_a, normal, depth, point.radius_a, round, Mat3::Zero()};
}

Sunk between_centres(const FrozenPoint& point, const Vec3& on_a, const Vec3& apart, const Vec3& normal) {
    const double distance = apart.norm();
    if (!(distance > 0)) {
        return against_plane(point, on_a, apart, normal);
    }
    const Vec3 direction = apart / distance;
    const Mat3 turning = (Mat3::Identity() - direction * direction.transpose()) / distance;
    const double depth = point.radius_a + point.radius_b - point.slack - distance;
    return {on_a, direction, depth, point.radius_a, true, turning};
}

/// Two bodies' poses, as they are needed for many points.
struct Turns {
    Mat3 a, b;
    Vec3 to_a;  // from B's origin to A's

    Turns(const Pose& pose_a, const Pose& pose_b)
        : a(pose_a.orientation.toRotationMatrix()),
          b(pose_b.orientation.toRotationMatrix()),
          to_a(pose_a.position - pose_b.position) {}

    [[nodiscard]] Sunk place(const FrozenPoint& point) const {
        const Vec3 on_a = a * point.on_a;
        const Vec3 apart = on_a + to_a - b * point.on_b;
        const bool round = point.radius_a > 0 && point.radius_b > 0;
        return round ? between_centres(point, on_a, apart, b * point.normal)
                     : against_plane(point, on_a, apart, b * point.normal);
    }
};

SunkPoints sunk_points(std::span<const FrozenPoint> points, const Pose& pose_a, const Pose& pose_b) {
    const Turns turns(pose_a, pose_b);
    SunkPoints sunk;
    for (const FrozenPoint& point : points) {
        sunk.all[sunk.count] = turns.place(point);
        sunk.count += sunk.all[sunk.count].depth > 0 ? 1 : 0;
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

// A's motion moves a point of A by da = u + θ × (a − c), its depth by −n·da and its prism's middle with it.
void add_rates(std::span<const Sunk> sunk, double share, ContactGeometry& g) {
    for (const Sunk& point : sunk) {
        const Vec3 arm = point.on_a - g.centroid;
        const auto add = [&](const Mat3& by_point, auto&& by_u, auto&& by_turn) {
            by_u += by_point;
            by_turn -= by_point * cross_matrix(arm);
        };
        const Vec3 off = point.middle() - g.centroid;
        add(share * (point.depth * point.middle_rate() - off * point.normal.transpose()), g.first_moment,
            g.second_moment);
        add(-share * point.normal_rate, g.boundary.topLeftCorner<3, 3>(), g.boundary.topRightCorner<3, 3>());
        add(share * (cross_matrix(point.normal) - cross_matrix(arm) * point.normal_rate),
            g.boundary.bottomLeftCorner<3, 3>(), g.boundary.bottomRightCorner<3, 3>());
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

// Round surfaces touch on a line along which all of them are; about it they roll.
Mat3 across_the_line(std::span<const Sunk> sunk) {
    const bool round = std::all_of(sunk.begin(), sunk.end(), [](const Sunk& point) { return point.round; });
    const Vec3 line = sunk.back().on_a - sunk.front().on_a;
    if (!round || line.isZero()) {
        return Mat3::Identity();
    }
    const Vec3 along = line.normalized();
    return Mat3::Identity() - along * along.transpose();
}

FrozenPoint turned_round(const FrozenPoint& point) {
    return {point.on_b, point.on_a, point.normal, point.radius_b, point.radius_a, point.slack};
}

}  // namespace

void FrozenPoints::freeze(std::span<const FrozenPoint> points, double area, Planes planes) {
    if (points.size() > most) {
        throw std::invalid_argument("more points than a contact can have");
    }
    exchanged_ = planes == Planes::of_a;
    std::transform(points.begin(), points.end(), points_.begin(),
                   [this](const FrozenPoint& point) { return exchanged_ ? turned_round(point) : point; });
    count_ = points.size();
    area_ = area;
}

std::optional<double> FrozenPoints::load_near(const Vec3& on_a, const Vec3& on_b, const Pose& pose_a,
                                              const Pose& pose_b, double distance) const {
    if (exchanged_) {
        FrozenPoints other = *this;
        other.exchanged_ = false;
        return other.load_near(on_b, on_a, pose_b, pose_a, distance);
    }
    std::optional<double> load;
    for (const FrozenPoint& point : std::span(points_).first(count_)) {
        const double apart = std::min((point.on_a - on_a).norm(), (point.on_b - on_b).norm());
        if (apart < distance) {
            distance = apart;
            load = std::max(0.0, Turns(pose_a, pose_b).place(point).depth);
        }
    }
    return load;
}

bool FrozenPoints::geometry(const Pose& pose_a, const Pose& pose_b, Detail /*detail*/, bool was_centre_line,
                            OverlapWorkspace& /*workspace*/, ContactGeometry& g) const {
    if (!exchanged_) {
        return on_planes_of_b(pose_a, pose_b, was_centre_line, g);
    }
    if (!on_planes_of_b(pose_b, pose_a, was_centre_line, g)) {
        return false;
    }
    g = scree::exchanged(g, pose_a.position - pose_b.position);
    return true;
}

bool FrozenPoints::on_planes_of_b(const Pose& pose_a, const Pose& pose_b, bool was_centre_line,
                                  ContactGeometry& g) const {
    const SunkPoints found = sunk_points(std::span(points_).first(count_), pose_a, pose_b);
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
    g.tilting = across_the_line(sunk);
    return true;
}

}  // namespace scree
