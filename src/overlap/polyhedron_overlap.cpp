#include "polyhedron_overlap.hpp"

#include <algorithm>
#include <limits>

#include "patch.hpp"

namespace scree {

namespace {

// An overlap thinner than this share of A's radius is rounding, and has no centroid.
constexpr double thinnest = 1e-16;

// Volume, patch, normal and their derivatives of what is left of A, in A's frame. `apart` is B → A in that
// frame.
bool describe(const OverlapPlanes& planes, const Vec3& apart, double radius, Detail detail,
              bool was_centre_line, const ClippedSolid& solid, ContactGeometry& geometry) {
    geometry = ContactGeometry{};
    const double surface = integrate_volume(solid, geometry);
    if (!(geometry.volume > thinnest * radius * surface)) {
        return false;
    }
    integrate_patch(solid, planes, geometry);
    if (detail == Detail::derivative) {
        integrate_boundary(solid, planes, geometry);
    }
    set_normal(geometry, surface, apart, -geometry.centroid, was_centre_line);
    measure_patch(solid, geometry);
    geometry.flat_patch = !geometry.centre_line;
    return true;
}

// B's planes in A's frame. Returns the one that A's centre is farthest outside of: it leaves a sliver, so
// that the others cost little. A negative number: the two are apart.
int bring_planes(const ConvexPolyhedron& a, const ConvexPolyhedron& b, const Pose& b_in_a,
                 std::vector<Plane>& planes) {
    const Mat3 turn = b_in_a.orientation.toRotationMatrix();
    planes.resize(b.planes.size());
    int farthest = 0;
    double height = -std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < planes.size(); ++j) {
        planes[j].normal = turn * b.planes[j].normal;
        planes[j].offset = b.planes[j].offset + planes[j].normal.dot(b_in_a.position);
        if (-planes[j].offset > height) {
            height = -planes[j].offset;
            farthest = static_cast<int>(j);
        }
    }
    return height > a.radius ? -1 : farthest;
}

// Whether a plane has the whole solid on its outer side.
bool beyond(const ConvexPolyhedron& solid, const Vec3& normal, double offset) {
    return std::none_of(solid.vertices.begin(), solid.vertices.end(),
                        [&](const Vec3& vertex) { return normal.dot(vertex) <= offset; });
}

// Whether A's face that B's centre is farthest outside of parts the two.
bool behind_a_face(const ConvexPolyhedron& a, const ConvexPolyhedron& b, const Pose& b_in_a) {
    const Plane* farthest = nullptr;
    double height = -std::numeric_limits<double>::infinity();
    for (const Plane& plane : a.planes) {
        const double above = plane.normal.dot(b_in_a.position) - plane.offset;
        if (above > height) {
            height = above;
            farthest = &plane;
        }
    }
    if (height > b.radius) {
        return true;
    }
    return height > 0 && beyond(b, b_in_a.orientation.conjugate() * farthest->normal, -height);
}

void keep_frame(const Pose& pose, OverlapWorkspace& workspace) {
    workspace.frame = pose;
    workspace.solid = true;
}

Pose relative(const Pose& pose_a, const Pose& pose_b) {
    const Quat back = pose_a.orientation.conjugate();
    return {back * (pose_b.position - pose_a.position), back * pose_b.orientation};
}

}  // namespace

bool overlap_polyhedra(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b,
                       const Pose& pose_b, Detail detail, bool was_centre_line, OverlapWorkspace& workspace,
                       ContactGeometry& geometry) {
    const double reach = a.radius + b.radius;
    if ((pose_b.position - pose_a.position).squaredNorm() > reach * reach) {
        return false;
    }
    const Pose b_in_a = relative(pose_a, pose_b);
    if (behind_a_face(a, b, b_in_a)) {
        return false;
    }
    const int first = bring_planes(a, b, b_in_a, workspace.planes);
    if (first < 0) {
        return false;
    }
    const Plane& parting = workspace.planes[static_cast<std::size_t>(first)];
    if (parting.offset < 0 && beyond(a, parting.normal, parting.offset)) {
        return false;
    }
    ClippedSolid& solid = workspace.clipped;
    solid.start(a);
    if (!solid.cut(parting, cut_tags + first)) {
        return false;
    }
    for (int j = 0; j < b.face_count(); ++j) {
        if (j != first && !solid.cut(workspace.planes[static_cast<std::size_t>(j)], cut_tags + j)) {
            return false;
        }
    }
    if (!describe({a.planes, workspace.planes}, -b_in_a.position, a.radius, detail, was_centre_line, solid,
                  geometry)) {
        return false;
    }
    rotate(geometry, pose_a.orientation.toRotationMatrix());
    keep_frame(pose_a, workspace);
    return true;
}

bool overlap_half_space(const ConvexPolyhedron& a, const Pose& pose_a, const HalfSpace& b, const Pose& pose_b,
                        Detail detail, OverlapWorkspace& workspace, ContactGeometry& geometry) {
    const Vec3 normal = pose_b.orientation * b.normal;
    const double height = normal.dot(pose_a.position - pose_b.position) - b.offset;
    if (height > a.radius) {
        return false;
    }
    workspace.planes.assign(1, {pose_a.orientation.conjugate() * normal, -height});
    ClippedSolid& solid = workspace.clipped;
    solid.start(a);
    if (!solid.cut(workspace.planes.front(), cut_tags)) {
        return false;
    }
    const Vec3 apart = workspace.planes.front().normal;
    if (!describe({a.planes, workspace.planes}, apart, a.radius, detail, false, solid, geometry)) {
        return false;
    }
    geometry.normal_rate.setZero();
    rotate(geometry, pose_a.orientation.toRotationMatrix());
    geometry.normal = normal;  // exact, whatever the rounding of the cut
    geometry.depth_moment = -geometry.volume * (height + normal.dot(geometry.centroid));
    keep_frame(pose_a, workspace);
    return true;
}

}  // namespace scree
