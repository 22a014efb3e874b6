#include "cut_cap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "circular_segment.hpp"
#include "gauss_points.hpp"

namespace scree {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double least_slope = 1e-12;  // of the second plane against the ground; below, they are parallel

/// The cap in axes (ahead, sideways, normal), where the second plane is x ≥ z · lean.
class LeaningCap {
  public:
    explicit LeaningCap(const CutCap& cap)
        : radius_(cap.radius), height_(std::max(cap.height, -cap.radius)), normal_(cap.normal) {
        const double up = cap.end.dot(cap.normal);
        const Vec3 flat = cap.end - up * cap.normal;
        slope_ = flat.norm();
        ahead_ = slope_ > least_slope ? Vec3(flat / slope_) : Vec3(cap.normal.unitOrthogonal());
        sideways_ = cap.normal.cross(ahead_);
        up_ = up;
    }

    [[nodiscard]] double depth() const { return radius_ - height_; }
    [[nodiscard]] double radius_at(double below) const {
        return std::sqrt(std::max(0.0, (radius_ - below) * (radius_ + below)));
    }
    /// What is left of the disc at a height below the centre.
    [[nodiscard]] CircularSegment segment(double below) const {
        if (slope_ > least_slope) {
            return {radius_at(below), below * up_ / slope_};
        }
        return {radius_at(below), (below * up_ < 0 ? -1 : 1) * radius_};
    }

    void sum_volume(ContactGeometry& g) const;
    void sum_patch(ContactGeometry& g) const;
    void sum_boundary(ContactGeometry& g) const;

  private:
    void add_slices(double from, double to, double& volume, Vec3& moment) const;
    void add_boundary_point(const Vec3& at, const Vec3& normal_a, double weight, ContactGeometry& g) const;

    double radius_, height_, slope_ = 0, up_ = 0;
    Vec3 normal_, ahead_, sideways_;
};

// Between two heights below the centre. Where the second plane leaves the ball, at the upper of them, a slice
// changes with a power of 3/2: squares of the integration variable make that smooth.
void LeaningCap::add_slices(double from, double to, double& volume, Vec3& moment) const {
    for (const GaussPoint& point : gauss_points()) {
        const double below = to - (to - from) * point.at * point.at;
        const double weight = 2 * (to - from) * point.at * point.weight;
        const CircularSegment slice = segment(below);
        volume += weight * slice.area;
        moment += weight * (slice.first * ahead_ - below * slice.area * normal_);
    }
}

// The second plane leaves the ball at heights ± radius·slope: slices between are cut, those beyond are whole
// or nothing.
void LeaningCap::sum_volume(ContactGeometry& g) const {
    double volume = 0;
    Vec3 moment = Vec3::Zero();
    const double turning = radius_ * slope_;
    const double low = std::clamp(-turning, height_, radius_);
    const double high = std::clamp(turning, height_, radius_);
    add_slices(height_, low, volume, moment);
    add_slices(low, high, volume, moment);
    add_slices(high, radius_, volume, moment);
    g.volume = volume;
    if (volume > 0) {
        g.centroid = moment / volume;
    }
}

// S and its moments from the flat side, as of a polyhedron's overlap.
void LeaningCap::sum_patch(ContactGeometry& g) const {
    const CircularSegment flat = segment(height_);
    const Vec3 base = -height_ * normal_ - g.centroid;  // from c to the disc's centre
    const Vec3 first = flat.area * base + flat.first * ahead_;
    Mat3 second = flat.area * base * base.transpose() + flat.along * ahead_ * ahead_.transpose() +
                  flat.across * sideways_ * sideways_.transpose();
    second += flat.first * (base * ahead_.transpose() + ahead_ * base.transpose());
    g.area_vector = -flat.area * normal_;
    g.area = flat.area;
    g.normal = normal_;
    g.depth = depth();
    g.first_moment = g.volume * Mat3::Identity() - first * normal_.transpose();
    g.second_moment = -second * cross_matrix(normal_);
}

void LeaningCap::add_boundary_point(const Vec3& at, const Vec3& normal_a, double weight,
                                    ContactGeometry& g) const {
    const Vec3 r = at - g.centroid;
    Eigen::Matrix<double, 6, 1> moved, gained;
    moved << normal_a, r.cross(normal_a);
    gained << normal_, r.cross(normal_);
    g.boundary -= weight * gained * moved.transpose();
}

// Along the arc an element over the sine of the angle between ball and ground is radius · angle.
void LeaningCap::sum_boundary(ContactGeometry& g) const {
    const double disc = radius_at(height_);
    const CircularSegment flat = segment(height_);
    const Vec3 base = -height_ * normal_;
    for (const GaussPoint& point : gauss_points()) {
        const double angle = (2 * point.at - 1) * flat.half_angle;
        const Vec3 at = base + disc * (std::cos(angle) * ahead_ + std::sin(angle) * sideways_);
        add_boundary_point(at, at / radius_, 2 * point.weight * flat.half_angle * radius_, g);
    }
    if (std::abs(height_ * up_) >= slope_ * disc) {
        return;  // the second plane does not cross the disc
    }
    const double half = disc * std::sin(flat.half_angle);
    const Vec3 inward = -(slope_ * ahead_ + up_ * normal_);
    const Vec3 middle = base + height_ * up_ / slope_ * ahead_;
    for (const double side : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
        add_boundary_point(middle + side * half * sideways_, inward, half / slope_, g);
    }
}

}  // namespace

bool overlap_cut_cap(const CutCap& cap, Detail detail, ContactGeometry& g) {
    const LeaningCap leaning(cap);
    if (!(leaning.depth() > 0)) {
        return false;
    }
    ContactGeometry found;
    leaning.sum_volume(found);
    if (!(found.volume > 0)) {
        return false;
    }
    leaning.sum_patch(found);
    if (detail == Detail::derivative) {
        leaning.sum_boundary(found);
    }
    found.depth_moment = -found.volume * (std::max(cap.height, -cap.radius) + cap.normal.dot(found.centroid));
    g = found;
    return true;
}

double whole_volume(const CutCap& cap) {
    const double depth = std::clamp(cap.radius - cap.height, 0.0, 2 * cap.radius);
    return pi * depth * depth * (cap.radius - depth / 3);
}

}  // namespace scree
