#include "capsule_overlap.hpp"

#include <array>
#include <type_traits>

#include "cut_cap.hpp"
#include "nearest_feature.hpp"
#include "parts.hpp"
#include "round_overlap.hpp"

namespace scree {

namespace {

/// What an overlap is made of: the side, two ends of A and two of B.
class Parts {
  public:
    /// Where the next one goes; take() keeps it.
    ContactGeometry& next() { return all_[count_]; }
    void take() { ++count_; }

    bool finish(const Pose& pose_a, const Pose& pose_b, bool was_centre_line,
                ContactGeometry& geometry) const;

  private:
    std::array<ContactGeometry, 5> all_;
    std::size_t count_ = 0;
};

bool Parts::finish(const Pose& pose_a, const Pose& pose_b, bool was_centre_line,
                   ContactGeometry& geometry) const {
    if (count_ == 0) {
        return false;
    }
    geometry = whole_of(std::span(all_).first(count_), pose_a.position - pose_b.position, was_centre_line);
    geometry.tilting = without(pose_a.orientation * Vec3::UnitZ());
    return true;
}

NearestFeature nearest_feature(const HalfSpace& ground, const Vec3& point) {
    return {ground.normal, ground.normal.dot(point) - ground.offset, Mat3::Zero()};
}

/// One of a capsule's ends against the other shape; world axes, origin at the capsule's centre.
struct EndContact {
    Vec3 centre;
    Mat3 normal_rate;
    CutCap cap;
};

template <class Solid>
EndContact end_contact(const Capsule& capsule, const Pose& pose, double sign, const Solid& other,
                       const Pose& pose_other) {
    const Vec3 axis = pose.orientation * Vec3(0, 0, sign);
    const Vec3 centre = capsule.half_length * axis;
    const Mat3 turn = pose_other.orientation.toRotationMatrix();
    const NearestFeature nearest =
        nearest_feature(other, turn.transpose() * (centre + pose.position - pose_other.position));
    return {centre,
            turn * nearest.normal_rate * turn.transpose(),
            {capsule.radius, axis, turn * nearest.normal, nearest.height}};
}

bool overlap_end(const EndContact& end, Detail detail, ContactGeometry& geometry) {
    if (!overlap_cut_cap(end.cap, detail, geometry)) {
        return false;
    }
    geometry.centroid += end.centre;
    follow_tangent(end.normal_rate, end.centre, end.cap.height, geometry);
    return true;
}

template <class Solid>
void add_ends(const Capsule& a, const Pose& pose_a, const Solid& b, const Pose& pose_b, Detail detail,
              Parts& parts) {
    for (const double sign : {-1.0, 1.0}) {
        if (overlap_end(end_contact(a, pose_a, sign, b, pose_b), detail, parts.next())) {
            parts.take();
        }
    }
}

// The share of a contact with A's end that is the end's own: the rest belongs to the side.
double share_of_end(const Capsule& a, const Pose& pose_a, double sign, const Capsule& b, const Pose& pose_b) {
    const EndContact end = end_contact(a, pose_a, sign, b, pose_b);
    ContactGeometry geometry;
    if (!overlap_cut_cap(end.cap, Detail::force, geometry)) {
        return 0;
    }
    return geometry.volume / whole_volume(end.cap);
}

// B's ends against A, as far as they are not A's ends against B.
void add_other_ends(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b, Detail detail,
                    Parts& parts) {
    const Vec3 apart = pose_a.position - pose_b.position;
    for (const double sign : {-1.0, 1.0}) {
        const EndContact end = end_contact(b, pose_b, sign, a, pose_a);
        ContactGeometry turned;
        if (!overlap_end(end, detail, turned)) {
            continue;
        }
        const double nearer = (pose_a.orientation * Vec3::UnitZ()).dot(end.centre - apart) < 0 ? -1 : 1;
        scale(turned, 1 - share_of_end(a, pose_a, nearer, b, pose_b));
        if (turned.volume > 0) {
            parts.next() = exchanged(turned, apart);
            parts.take();
        }
    }
}

bool near(const Capsule& a, const Pose& pose_a, double radius_b, const Pose& pose_b) {
    const double reach = a.half_length + a.radius + radius_b;
    return (pose_a.position - pose_b.position).squaredNorm() <= reach * reach;
}

/// The side by `side(geometry)`, then the ends, then the whole.
template <class Other, class Side>
bool overlap_in_parts(const Capsule& a, const Pose& pose_a, const Other& b, const Pose& pose_b, Detail detail,
                      bool was_centre_line, ContactGeometry& geometry, Side&& side) {
    Parts parts;
    if (side(parts.next())) {
        parts.take();
    }
    add_ends(a, pose_a, b, pose_b, detail, parts);
    if constexpr (std::is_same_v<Other, Capsule>) {
        add_other_ends(a, pose_a, b, pose_b, detail, parts);
    }
    return parts.finish(pose_a, pose_b, was_centre_line, geometry);
}

}  // namespace

bool overlap_capsule(const Capsule& a, const Pose& pose_a, const HalfSpace& b, const Pose& pose_b,
                     Detail detail, bool was_centre_line, OverlapWorkspace& workspace, ContactGeometry& g) {
    const auto side = [&](ContactGeometry& part) {
        return overlap_facets(faceted(a), pose_a, b, pose_b, detail, workspace, part);
    };
    return overlap_in_parts(a, pose_a, b, pose_b, detail, was_centre_line, g, side);
}

bool overlap_capsule(const Capsule& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
                     Detail detail, bool was_centre_line, OverlapWorkspace& workspace, ContactGeometry& g) {
    const auto side = [&](ContactGeometry& part) {
        return overlap_facets(faceted(a), pose_a, b, pose_b, detail, was_centre_line, workspace, part);
    };
    return near(a, pose_a, b.radius, pose_b) &&
           overlap_in_parts(a, pose_a, b, pose_b, detail, was_centre_line, g, side);
}

bool overlap_capsule(const Capsule& a, const Pose& pose_a, const Frustum& b, const Pose& pose_b,
                     Detail detail, bool was_centre_line, OverlapWorkspace& workspace, ContactGeometry& g) {
    const auto side = [&](ContactGeometry& part) {
        return overlap_facets(faceted(a), pose_a, faceted(b), pose_b, detail, was_centre_line, workspace,
                              part);
    };
    return near(a, pose_a, b.facets.radius, pose_b) &&
           overlap_in_parts(a, pose_a, b, pose_b, detail, was_centre_line, g, side);
}

bool overlap_capsule(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b,
                     Detail detail, bool was_centre_line, OverlapWorkspace& workspace, ContactGeometry& g) {
    const auto side = [&](ContactGeometry& part) {
        return overlap_facets(faceted(a), pose_a, faceted(b), pose_b, detail, was_centre_line, workspace,
                              part);
    };
    return near(a, pose_a, b.half_length + b.radius, pose_b) &&
           overlap_in_parts(a, pose_a, b, pose_b, detail, was_centre_line, g, side);
}

}  // namespace scree
