#include <scree/overlap/overlap.hpp>

#include <stdexcept>

#include "capsule_overlap.hpp"
#include "polyhedron_overlap.hpp"
#include "round_overlap.hpp"
#include "smooth_overlap.hpp"

namespace scree {

namespace {

struct Overlap {
    const Pose& pose_a;
    const Pose& pose_b;
    Detail detail;
    bool was_centre_line;
    OverlapWorkspace& workspace;
    ContactGeometry& geometry;

    bool operator()(const ConvexPolyhedron& a, const ConvexPolyhedron& b) const {
        return overlap_polyhedra(a, pose_a, b, pose_b, detail, was_centre_line, workspace, geometry);
    }
    bool operator()(const ConvexPolyhedron& a, const HalfSpace& b) const {
        return overlap_half_space(a, pose_a, b, pose_b, detail, workspace, geometry);
    }
    bool operator()(const Sphere& a, const HalfSpace& b) const {
        return overlap_cap(a, pose_a, b, pose_b, geometry);
    }
    bool operator()(const Sphere& a, const Sphere& b) const {
        return overlap_lens(a, pose_a, b, pose_b, geometry);
    }

    bool operator()(const Sphere& a, const ConvexPolyhedron& b) const {
        return overlap_nearest(a, pose_a, b, pose_b, geometry);
    }
    bool operator()(const Sphere& a, const Frustum& b) const {
        return overlap_nearest(a, pose_a, b, pose_b, geometry);
    }
    bool operator()(const Sphere& a, const Capsule& b) const {
        return overlap_nearest(a, pose_a, b, pose_b, geometry);
    }
    bool operator()(const Frustum& a, const HalfSpace& b) const {
        return overlap_facets(faceted(a), pose_a, b, pose_b, detail, workspace, geometry);
    }
    bool operator()(const Frustum& a, const ConvexPolyhedron& b) const {
        return overlap_facets(faceted(a), pose_a, b, pose_b, detail, was_centre_line, workspace, geometry);
    }
    bool operator()(const Frustum& a, const Frustum& b) const {
        return overlap_facets(faceted(a), pose_a, faceted(b), pose_b, detail, was_centre_line, workspace,
                              geometry);
    }
    template <class Other>
    bool operator()(const Capsule& a, const Other& b) const {
        return overlap_capsule(a, pose_a, b, pose_b, detail, was_centre_line, workspace, geometry);
    }
    bool operator()(const Capsule& a, const Sphere& b) const { return turned(a, b); }

    // What is not known one way round is asked the other way round.
    bool operator()(const HalfSpace& a, const ConvexPolyhedron& b) const { return turned(a, b); }
    bool operator()(const HalfSpace& a, const Sphere& b) const { return turned(a, b); }
    bool operator()(const ConvexPolyhedron& a, const Sphere& b) const { return turned(a, b); }
    bool operator()(const HalfSpace& a, const Frustum& b) const { return turned(a, b); }
    bool operator()(const ConvexPolyhedron& a, const Frustum& b) const { return turned(a, b); }
    bool operator()(const HalfSpace& a, const Capsule& b) const { return turned(a, b); }
    bool operator()(const ConvexPolyhedron& a, const Capsule& b) const { return turned(a, b); }
    bool operator()(const Frustum& a, const Sphere& b) const { return turned(a, b); }
    bool operator()(const Frustum& a, const Capsule& b) const { return turned(a, b); }
    template <class A, class B>
    bool turned(const A& a, const B& b) const {
        const Overlap other{pose_b, pose_a, detail, was_centre_line, workspace, geometry};
        if (!other(b, a)) {
            return false;
        }
        geometry = exchanged(geometry, pose_a.position - pose_b.position);
        return true;
    }
    bool operator()(const HalfSpace&, const HalfSpace&) const {
        throw std::invalid_argument("two half-spaces have no bounded overlap");
    }
    template <class Other>
    bool operator()(const OpenSurface&, const Other&) const {
        return nothing_to_share();
    }
    template <class Other>
    bool operator()(const Other&, const OpenSurface&) const {
        return nothing_to_share();
    }
    bool operator()(const OpenSurface&, const OpenSurface&) const { return nothing_to_share(); }
    bool operator()(const Capsule&, const OpenSurface&) const { return nothing_to_share(); }
    static bool nothing_to_share() {
        throw std::invalid_argument("an open surface encloses nothing that could be shared");
    }
};

}  // namespace

bool overlap(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Detail detail,
             bool was_centre_line, OverlapWorkspace& workspace, ContactGeometry& geometry) {
    workspace.solid = false;
    return std::visit(Overlap{pose_a, pose_b, detail, was_centre_line, workspace, geometry}, a, b);
}

std::vector<Vec3> patch_outline(const OverlapWorkspace& workspace) {
    std::vector<Vec3> corners;
    const ClippedSolid& solid = workspace.clipped;
    for (const ClippedSolid::Face& face : solid.faces()) {
        if (face.tag < cut_tags) {
            continue;
        }
        for (int e = face.begin; e < face.end; ++e) {
            const HalfEdge& edge = solid.half_edges()[static_cast<std::size_t>(e)];
            if (edge.across < cut_tags) {
                corners.push_back(solid.point(edge.vertex));
            }
        }
    }
    return corners;
}

}  // namespace scree
