#include "nearest_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "nearest_feature.hpp"

namespace scree {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// The shortest way from one segment to another. Among the ends' ways to the other segment and, for lines that
// are not parallel, the way between their own nearest points, if these are on the segments.
class ShortestWay {
  public:
    ShortestWay(const Segment& from, const Segment& to) {
        const Vec3 along = from.to - from.from;
        const Vec3 other = to.to - to.from;
        const Vec3 apart = to.from - from.from;
        for (const Vec3& end : {to.from, to.to}) {
            take(end - (from.from + share(end - from.from, along) * along));
        }
        for (const Vec3& end : {from.from, from.to}) {
            take(to.from + share(end - to.from, other) * other - end);
        }
        const Vec3 across = along.cross(other);
        const double square = across.squaredNorm();
        if (square > 0) {
            const double on_from = apart.cross(other).dot(across) / square;
            const double on_to = apart.cross(along).dot(across) / square;
            if (on_from > 0 && on_from < 1 && on_to > 0 && on_to < 1) {
                take(apart.dot(across) / square * across);
            }
        }
    }

    [[nodiscard]] const Vec3& way() const { return way_; }
    [[nodiscard]] double length() const { return length_; }

  private:
    static double share(const Vec3& point, const Vec3& along) {
        const double square = along.squaredNorm();
        return square > 0 ? std::clamp(point.dot(along) / square, 0.0, 1.0) : 0;
    }
    void take(const Vec3& way) {
        const double length = way.norm();
        if (length < length_) {
            way_ = way;
            length_ = length;
        }
    }

    Vec3 way_ = Vec3::Zero();
    double length_ = std::numeric_limits<double>::infinity();
};

// The middle of the part of the segment that is inside the solid.
std::optional<Vec3> middle_inside(const ConvexPolyhedron& solid, const Segment& segment) {
    double low = 0;
    double high = 1;
    for (const Plane& plane : solid.planes) {
        const double start = plane.normal.dot(segment.from) - plane.offset;
        const double end = plane.normal.dot(segment.to) - plane.offset;
        if (start > 0 && end > 0) {
            return std::nullopt;
        }
        if (start > 0) {
            low = std::max(low, start / (start - end));
        } else if (end > 0) {
            high = std::min(high, start / (start - end));
        }
    }
    if (low > high) {
        return std::nullopt;
    }
    return segment.from + 0.5 * (low + high) * (segment.to - segment.from);
}

}  // namespace

Vec3 direction_from(const ConvexPolyhedron& solid, const Segment& segment) {
    if (const auto middle = middle_inside(solid, segment)) {
        return nearest_feature(solid, *middle).normal;
    }
    Vec3 direction = Vec3::UnitZ();
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& end : {segment.from, segment.to}) {
        const NearestFeature nearest = nearest_feature(solid, end);
        if (nearest.height < least) {
            least = nearest.height;
            direction = nearest.normal;
        }
    }
    for (int f = 0; f < solid.face_count(); ++f) {
        const int begin = solid.face_begin[at(f)];
        const int end = solid.face_begin[at(f) + 1];
        for (int e = begin; e < end; ++e) {
            if (solid.half_edges[at(e)].across < f) {
                continue;  // once an edge
            }
            const int next = e + 1 < end ? e + 1 : begin;
            const ShortestWay found({solid.vertices[at(solid.half_edges[at(e)].vertex)],
                                     solid.vertices[at(solid.half_edges[at(next)].vertex)]},
                                    segment);
            if (found.length() < least && found.length() > 0) {
                least = found.length();
                direction = found.way() / found.length();
            }
        }
    }
    return direction;
}

Vec3 direction_from(const Segment& from, const Segment& to) {
    const ShortestWay found(from, to);
    if (found.length() > 0) {
        return found.way() / found.length();
    }
    const Vec3 across = (from.to - from.from).cross(to.to - to.from);
    return across.isZero() ? Vec3((to.to - to.from).unitOrthogonal()) : Vec3(across.normalized());
}

}  // namespace scree
