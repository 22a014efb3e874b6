#include "nearest_feature.hpp"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// The point of an edge that is nearest to `point`, and whether it is an end.
struct NearestOnEdge {
    Vec3 offset;  // from there to the point
    bool is_vertex;
};

NearestOnEdge nearest_on_edge(const Vec3& start, const Vec3& end, const Vec3& point) {
    const Vec3 along = end - start;
    const double share = (point - start).dot(along) / along.squaredNorm();
    const double inside = std::clamp(share, 0.0, 1.0);
    return {point - start - inside * along, inside != share};
}

// Whether the point lies over the face: on the inner side of every edge, along the face's normal.
bool over_face(const ConvexPolyhedron& solid, int face, const Vec3& point) {
    const int begin = solid.face_begin[at(face)];
    const int end = solid.face_begin[at(face) + 1];
    for (int e = begin; e < end; ++e) {
        const Vec3& from = solid.vertices[at(solid.half_edges[at(e)].vertex)];
        const Vec3& to = solid.vertices[at(solid.half_edges[at(e + 1 < end ? e + 1 : begin)].vertex)];
        if (solid.planes[at(face)].normal.cross(to - from).dot(point - from) < 0) {
            return false;
        }
    }
    return true;
}

double height_above(const Plane& plane, const Vec3& point) {
    return plane.normal.dot(point) - plane.offset;
}

// Among the edges of all faces that the point can see.
NearestFeature nearest_edge_or_vertex(const ConvexPolyhedron& solid, const Vec3& point) {
    NearestFeature nearest;
    double least = std::numeric_limits<double>::infinity();
    for (int f = 0; f < solid.face_count(); ++f) {
        if (height_above(solid.planes[at(f)], point) <= 0) {
            continue;
        }
        const int begin = solid.face_begin[at(f)];
        const int end = solid.face_begin[at(f) + 1];
        for (int e = begin; e < end; ++e) {
            const Vec3& from = solid.vertices[at(solid.half_edges[at(e)].vertex)];
            const Vec3& to = solid.vertices[at(solid.half_edges[at(e + 1 < end ? e + 1 : begin)].vertex)];
            const NearestOnEdge found = nearest_on_edge(from, to, point);
            const double distance = found.offset.norm();
            if (!(distance < least) || distance == 0) {
                continue;
            }
            least = distance;
            nearest.height = distance;
            nearest.normal = found.offset / distance;
            Mat3 across = Mat3::Identity() - nearest.normal * nearest.normal.transpose();
            if (!found.is_vertex) {
                const Vec3 along = (to - from).normalized();
                across -= along * along.transpose();
            }
            nearest.normal_rate = across / distance;
        }
    }
    return nearest;
}

}  // namespace

NearestFeature nearest_feature(const ConvexPolyhedron& solid, const Vec3& point) {
    int highest = 0;
    double height = -std::numeric_limits<double>::infinity();
    for (int f = 0; f < solid.face_count(); ++f) {
        const double above = height_above(solid.planes[at(f)], point);
        if (above > height) {
            height = above;
            highest = f;
        }
        if (above > 0 && over_face(solid, f, point)) {
            return {solid.planes[at(f)].normal, above, Mat3::Zero()};
        }
    }
    if (height > 0) {
        const NearestFeature found = nearest_edge_or_vertex(solid, point);
        if (found.height > 0) {
            return found;
        }
    }
    return {solid.planes[at(highest)].normal, height, Mat3::Zero()};
}

}  // namespace scree
