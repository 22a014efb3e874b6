#include <scree/overlap/contact_points.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

constexpr double least_depth = 0.1;  // of the deepest point
constexpr double inwards = 1e-3;     // of the way to the centre
constexpr double parallel = 1e-9;    // sine between a face and the normal, below which the face is no end

/// Everything in the frame of the clipped solid.
class Chords {
  public:
    Chords(const ClippedSolid& solid, const Vec3& normal) : solid_(solid), normal_(normal) {}

    /// Through a point of the solid.
    [[nodiscard]] Chord through(const Vec3& at) const {
        Chord chord{at, -infinity, infinity};
        for (const ClippedSolid::Face& face : solid_.faces()) {
            end_at(face, chord);
        }
        if (!(chord.high > chord.low) || std::isinf(chord.high) || std::isinf(chord.low)) {
            chord.low = chord.high = 0;
        }
        return chord;
    }

    /// Through a corner or, where that is much longer, a little nearer to the centre: a side that leans
    /// inwards by a hair leaves the line through its corner no length.
    [[nodiscard]] Chord beside(const Vec3& corner, const Vec3& centre) const {
        const Chord outer = through(corner);
        const Chord inner = through(corner + inwards * (centre - corner));
        return inner.depth() > (1 + 10 * inwards) * outer.depth() ? inner : outer;
    }

  private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    [[nodiscard]] const Vec3& corner(int half_edge) const {
        return solid_.point(solid_.half_edges()[static_cast<std::size_t>(half_edge)].vertex);
    }
    void end_at(const ClippedSolid::Face& face, Chord& chord) const {
        const Vec3& first = corner(face.begin);
        Vec3 area = Vec3::Zero();
        for (int e = face.begin + 1; e + 1 < face.end; ++e) {
            area += (corner(e) - first).cross(corner(e + 1) - first);
        }
        const double along = area.dot(normal_);
        if (std::abs(along) <= parallel * area.norm()) {
            return;
        }
        const double height = area.dot(first - chord.at) / along;
        if (along > 0) {
            chord.high = std::max(0.0, std::min(chord.high, height));
        } else {
            chord.low = std::min(0.0, std::max(chord.low, height));
        }
    }

    const ClippedSolid& solid_;
    Vec3 normal_;
};

/// Picks the points of a set that spread widest, one after another.
class Spread {
  public:
    Spread(const Vec3& normal, double spacing) : normal_(normal), spacing_(spacing) {}

    /// How much a point adds to those that were taken: a distance, then the distance from their line, then
    /// that on its other side. Negative: too near to one of them.
    [[nodiscard]] double gain(const Vec3& point) const {
        for (std::size_t i = 0; i < count_; ++i) {
            if (!(flat(point - taken_[i]).norm() > spacing_)) {
                return -1;
            }
        }
        const Vec3 from_first = flat(point - taken_[0]);
        if (count_ <= 1) {
            return count_ == 0 ? 0 : from_first.norm();
        }
        const double side = normal_.dot(flat(taken_[1] - taken_[0]).cross(from_first));
        if (count_ == 2) {
            return std::abs(side);
        }
        const double other = normal_.dot(flat(taken_[1] - taken_[0]).cross(flat(taken_[2] - taken_[0])));
        return side * other < 0 ? std::abs(side) : 0;
    }
    void take(const Vec3& point) { taken_[count_++] = point; }

  private:
    [[nodiscard]] Vec3 flat(const Vec3& v) const { return v - v.dot(normal_) * normal_; }

    Vec3 normal_;
    double spacing_;
    std::array<Vec3, ContactPoints::most> taken_;
    std::size_t count_ = 0;
};

/// The corner that adds most of those that are deep enough; null: none adds anything.
const Chord* widest_of(const std::vector<Chord>& corners, double least, const Spread& spread) {
    const Chord* widest = nullptr;
    double gain = 0;
    for (const Chord& corner : corners) {
        const double own = corner.depth() < least ? -1 : spread.gain(corner.at);
        if (own > gain * (1 + 1e-9)) {
            gain = own;
            widest = &corner;
        }
    }
    return widest;
}

}  // namespace

ContactPoints::ContactPoints(const Shape& a, const Pose& pose_a, const ContactGeometry& geometry,
                             OverlapWorkspace& workspace, double spacing) {
    if (workspace.solid && !geometry.centre_line) {
        add_corners(pose_a, geometry, workspace, spacing);
    }
    if (count_ == 0) {
        add_smooth(a, pose_a, geometry);
    }
}

// On the line along the normal through the centroid, down to where A ends.
void ContactPoints::add_smooth(const Shape& a, const Pose& pose_a, const ContactGeometry& g) {
    const double reach = reach_along(a, pose_a.orientation.conjugate() * -g.normal);
    ContactPoint& point = points_[count_++];
    const double below = g.normal.dot(g.centroid) + (std::isfinite(reach) ? reach : 0.5 * g.depth);
    point.on_a = pose_a.position + g.centroid - below * g.normal;
    point.depth = g.depth;
    point.on_b = point.on_a + point.depth * g.normal;
}

void ContactPoints::add_corners(const Pose& pose_a, const ContactGeometry& g, OverlapWorkspace& workspace,
                                double spacing) {
    const Quat back = workspace.frame.orientation.conjugate();
    const Vec3 normal = back * g.normal;
    const Chords chords(workspace.clipped, normal);
    const Vec3 centre = back * (pose_a.position + g.centroid - workspace.frame.position);
    Chord deepest = chords.through(centre);
    std::vector<Chord>& corners = workspace.chords;
    corners.clear();
    for (const int vertex : workspace.clipped.vertices()) {
        corners.push_back(chords.beside(workspace.clipped.point(vertex), centre));
        // Of equal depths a corner rather than the middle.
        if (corners.back().depth() > deepest.depth() * (1 - 1e-6)) {
            deepest = corners.back();
        }
    }
    if (!(deepest.depth() > 0)) {
        return;
    }
    Spread spread(normal, spacing);
    const auto take = [&](const Chord& chord) {
        spread.take(chord.at);
        ContactPoint& point = points_[count_++];
        point.on_a = workspace.frame * (chord.at + chord.low * normal);
        point.depth = chord.depth();
        point.on_b = point.on_a + point.depth * g.normal;
    };
    take(deepest);
    while (count_ < most) {
        const Chord* const widest = widest_of(corners, least_depth * deepest.depth(), spread);
        if (widest == nullptr) {
            return;
        }
        take(*widest);
    }
}

}  // namespace scree
