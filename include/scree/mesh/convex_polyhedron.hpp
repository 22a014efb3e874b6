#pragma once

#include <vector>

#include <scree/mesh/pose.hpp>
#include <scree/mesh/triangle_mesh.hpp>

namespace scree {

/// The points x with normal·x ≤ offset.
struct Plane {
    Vec3 normal = Vec3::UnitZ();  ///< unit, outward
    double offset = 0;            ///< [m]
};

/// One directed edge of a face: it starts at `vertex` and has the face `across` on its other side.
struct HalfEdge {
    int vertex = 0;  ///< number of the vertex
    int across = 0;  ///< number of the face
};

/// A closed convex polyhedron with planar polygonal faces, ready to be clipped. Face f owns the half-edges
/// face_begin[f] … face_begin[f + 1], counter-clockwise seen from outside.
struct ConvexPolyhedron {
    std::vector<Vec3> vertices;        ///< [m]
    std::vector<Plane> planes;         ///< one a face
    std::vector<int> face_begin{0};    ///< faces + 1 entries
    std::vector<HalfEdge> half_edges;  ///< of all faces, one face's in a row
    double radius = 0;                 ///< [m], of the sphere about the origin that holds all vertices
    double width = 0;                  ///< [m], the least extent along the normal of a face

    /// How many faces.
    [[nodiscard]] int face_count() const { return static_cast<int>(planes.size()); }
};

/// The polyhedron of closed, consistently oriented faces given as loops of vertex numbers. Planes are those
/// of the loops' area vectors, each pushed out to its loop's farthest vertex. Throws std::invalid_argument
/// when an edge is not shared by exactly two faces or a face has no area.
ConvexPolyhedron make_polyhedron(std::vector<Vec3> vertices, const std::vector<std::vector<int>>& faces);

/// The box with the full edge lengths `edges` [m], centred on the origin.
ConvexPolyhedron make_box(const Vec3& edges);

/// The same solid seen from another frame: every point x becomes motion * x.
ConvexPolyhedron transformed(const ConvexPolyhedron& solid, const Pose& motion);

}  // namespace scree
