#pragma once

#include <scree/overlap/overlap.hpp>

namespace scree {

bool overlap_cap(const Sphere& a, const Pose& pose_a, const HalfSpace& b, const Pose& pose_b,
                 ContactGeometry& geometry);

bool overlap_lens(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b,
                  ContactGeometry& geometry);

/// The cap of the depth by which the sphere's surface lies under the nearest point of the other, as if that
/// were flat there.
bool overlap_nearest(const Sphere& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
                     ContactGeometry& geometry);
bool overlap_nearest(const Sphere& a, const Pose& pose_a, const Frustum& b, const Pose& pose_b,
                     ContactGeometry& geometry);
bool overlap_nearest(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b,
                     ContactGeometry& geometry);

}  // namespace scree
