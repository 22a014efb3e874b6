#include <scree/mesh/convex_polyhedron.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "directed_edges.hpp"
#include "loop_normal.hpp"

namespace scree {

namespace {

using Loop = std::vector<int>;

void check_loops(const std::vector<Vec3>& vertices, const std::vector<Loop>& faces) {
    const int count = static_cast<int>(vertices.size());
    for (const Loop& loop : faces) {
        if (loop.size() < 3) {
            throw std::invalid_argument("a face needs at least three vertices, found " +
                                        std::to_string(loop.size()));
        }
        if (std::any_of(loop.begin(), loop.end(), [&](int v) { return v < 0 || v >= count; })) {
            throw std::invalid_argument("a face names a vertex that is not there");
        }
    }
}

DirectedEdges edges_of(const std::vector<Loop>& faces) {
    DirectedEdges edges;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        int from = faces[f].back();
        for (const int to : faces[f]) {
            if (from == to || !edges.add(from, to, static_cast<int>(f))) {
                throw std::invalid_argument("the edge from vertex " + std::to_string(from) + " to " +
                                            std::to_string(to) + " is used twice in one direction");
            }
            from = to;
        }
    }
    return edges;
}

/// The plane of the loop's normal through the loop's farthest vertex.
Plane plane_of(const std::vector<Vec3>& vertices, const Loop& loop) {
    Plane plane{loop_normal(vertices, loop), -std::numeric_limits<double>::infinity()};
    if (plane.normal.isZero()) {
        throw std::invalid_argument("a face has no area");
    }
    for (const int v : loop) {
        plane.offset = std::max(plane.offset, plane.normal.dot(vertices[v]));
    }
    return plane;
}

double radius_of(const std::vector<Vec3>& vertices) {
    double square = 0;
    for (const Vec3& v : vertices) {
        square = std::max(square, v.squaredNorm());
    }
    return std::sqrt(square);
}

double width_of(const std::vector<Vec3>& vertices, const std::vector<Plane>& planes) {
    double least = std::numeric_limits<double>::infinity();
    for (const Plane& plane : planes) {
        double lowest = plane.offset;
        for (const Vec3& v : vertices) {
            lowest = std::min(lowest, plane.normal.dot(v));
        }
        least = std::min(least, plane.offset - lowest);
    }
    return least;
}

}  // namespace

ConvexPolyhedron make_polyhedron(std::vector<Vec3> vertices, const std::vector<std::vector<int>>& faces) {
    check_loops(vertices, faces);
    const DirectedEdges edges = edges_of(faces);
    ConvexPolyhedron solid;
    for (const Loop& loop : faces) {
        solid.planes.push_back(plane_of(vertices, loop));
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int to = loop[(i + 1) % loop.size()];
            const int across = edges.owner(to, loop[i]);
            if (across == DirectedEdges::none) {
                throw std::invalid_argument("the edge from vertex " + std::to_string(loop[i]) + " to " +
                                            std::to_string(to) + " has a face on one side only");
            }
            solid.half_edges.push_back({loop[i], across});
        }
        solid.face_begin.push_back(static_cast<int>(solid.half_edges.size()));
    }
    solid.radius = radius_of(vertices);
    solid.width = width_of(vertices, solid.planes);
    solid.vertices = std::move(vertices);
    return solid;
}

ConvexPolyhedron make_box(const Vec3& edges) {
    if (!edges.allFinite() || edges.minCoeff() <= 0) {
        throw std::invalid_argument("the edges of a box must be positive and finite");
    }
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
        const Vec3 signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
        corners.emplace_back(signs.cwiseProduct(edges) / 2);
    }
    return make_polyhedron(
        std::move(corners),
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

ConvexPolyhedron transformed(const ConvexPolyhedron& solid, const Pose& motion) {
    ConvexPolyhedron moved = solid;
    const Mat3 rotation = motion.orientation.toRotationMatrix();
    for (Vec3& v : moved.vertices) {
        v = rotation * v + motion.position;
    }
    for (Plane& plane : moved.planes) {
        plane.normal = rotation * plane.normal;
        plane.offset += plane.normal.dot(motion.position);
    }
    moved.radius = radius_of(moved.vertices);
    return moved;
}

}  // namespace scree
