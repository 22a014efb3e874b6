#pragma once

#include <scree/overlap/overlap.hpp>

#include "facets.hpp"

namespace scree {

/// The overlap of facets that are turned to where the other shape is.
bool overlap_facets(const Faceted& a, const Pose& pose_a, const HalfSpace& b, const Pose& pose_b,
                    Detail detail, OverlapWorkspace& workspace, ContactGeometry& geometry);

bool overlap_facets(const Faceted& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
                    Detail detail, bool was_centre_line, OverlapWorkspace& workspace,
                    ContactGeometry& geometry);

/// Of both, each turned to where the other is.
bool overlap_facets(const Faceted& a, const Pose& pose_a, const Faceted& b, const Pose& pose_b, Detail detail,
                    bool was_centre_line, OverlapWorkspace& workspace, ContactGeometry& geometry);

}  // namespace scree
