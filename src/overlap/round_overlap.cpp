#include "round_overlap.hpp"

#include "polyhedron_overlap.hpp"

namespace scree {

namespace {

bool near(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b) {
    const double reach = a.radius + b.radius;
    return (pose_a.position - pose_b.position).squaredNorm() <= reach * reach;
}

}  // namespace

bool overlap_facets(const Faceted& a, const Pose& pose_a, const HalfSpace& b, const Pose& pose_b,
                    Detail detail, OverlapWorkspace& workspace, ContactGeometry& geometry) {
    const FacetPose facets = facet_pose(pose_a, facing(b.normal, pose_b.orientation));
    if (!overlap_half_space(a.solid, facets.pose, b, pose_b, detail, workspace, geometry)) {
        return false;
    }
    follow_facets(facets, geometry);
    return true;
}

bool overlap_facets(const Faceted& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
                    Detail detail, bool was_centre_line, OverlapWorkspace& workspace,
                    ContactGeometry& geometry) {
    if (!near(a.solid, pose_a, b, pose_b)) {
        return false;
    }
    const Vec3 apart = direction_from(b, pose_b.inverse() * pose_a * a.core);
    const FacetPose facets = facet_pose(pose_a, facing(apart, pose_b.orientation));
    if (!overlap_polyhedra(a.solid, facets.pose, b, pose_b, detail, was_centre_line, workspace, geometry)) {
        return false;
    }
    follow_facets(facets, geometry);
    return true;
}

bool overlap_facets(const Faceted& a, const Pose& pose_a, const Faceted& b, const Pose& pose_b, Detail detail,
                    bool was_centre_line, OverlapWorkspace& workspace, ContactGeometry& geometry) {
    if (!near(a.solid, pose_a, b.solid, pose_b)) {
        return false;
    }
    const Vec3 apart = direction_from(b.core, pose_b.inverse() * pose_a * a.core);
    const Facing from_a = facing(apart, pose_b.orientation);
    const FacetPose facets_a = facet_pose(pose_a, from_a);
    const FacetPose facets_b = facet_pose(pose_b, {-from_a.toward, from_a.otherwise});
    if (!overlap_polyhedra(a.solid, facets_a.pose, b.solid, facets_b.pose, detail, was_centre_line, workspace,
                           geometry)) {
        return false;
    }
    follow_facets(facets_a, geometry);
    geometry.tilting = without(facets_b.axis) * geometry.tilting;
    return true;
}

}  // namespace scree
