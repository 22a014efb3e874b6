#pragma once

#include <scree/overlap/overlap.hpp>

namespace scree {

/// Tags of the faces that B's planes cut into A's copy start here, above A's own face numbers.
constexpr int cut_tags = 1 << 24;

bool overlap_polyhedra(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b,
                       const Pose& pose_b, Detail detail, bool was_centre_line, OverlapWorkspace& workspace,
                       ContactGeometry& geometry);

bool overlap_half_space(const ConvexPolyhedron& a, const Pose& pose_a, const HalfSpace& b, const Pose& pose_b,
                        Detail detail, OverlapWorkspace& workspace, ContactGeometry& geometry);

}  // namespace scree
