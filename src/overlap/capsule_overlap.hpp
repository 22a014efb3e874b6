#pragma once

#include <scree/overlap/overlap.hpp>

namespace scree {

/// A capsule's overlap is that of its side, by facets that are turned to where the other shape is, and of its
/// two round ends, each the cap below the other shape's nearest tangent plane, cut where the side begins:
/// exact on a half-space but for the facets.
bool overlap_capsule(const Capsule& a, const Pose& pose_a, const HalfSpace& b, const Pose& pose_b,
                     Detail detail, bool was_centre_line, OverlapWorkspace& workspace,
                     ContactGeometry& geometry);
bool overlap_capsule(const Capsule& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
                     Detail detail, bool was_centre_line, OverlapWorkspace& workspace,
                     ContactGeometry& geometry);
bool overlap_capsule(const Capsule& a, const Pose& pose_a, const Frustum& b, const Pose& pose_b,
                     Detail detail, bool was_centre_line, OverlapWorkspace& workspace,
                     ContactGeometry& geometry);
bool overlap_capsule(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b,
                     Detail detail, bool was_centre_line, OverlapWorkspace& workspace,
                     ContactGeometry& geometry);

}  // namespace scree
