#pragma once

#include <scree/mesh/convex_polyhedron.hpp>

namespace scree {

/// A straight piece of line.
struct Segment {
    Vec3 from, to;  ///< [m]
};

inline Segment operator*(const Pose& pose, const Segment& segment) {
    return {pose * segment.from, pose * segment.to};
}

/// The unit direction from where a solid is nearest to a segment to there on the segment. Of a segment that
/// enters the solid: out of the face that the middle of the inner part is nearest to. Continuous but for
/// that.
Vec3 direction_from(const ConvexPolyhedron& solid, const Segment& segment);

/// The same between two segments; of segments that meet, some direction across both.
Vec3 direction_from(const Segment& from, const Segment& to);

}  // namespace scree
