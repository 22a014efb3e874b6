#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <scree/mesh/convex_polyhedron.hpp>

namespace scree::test {

inline ConvexPolyhedron cube(double edge) {
    return make_box(Vec3::Constant(edge));
}

/// The faces of a solid as loops of vertex numbers.
inline std::vector<std::vector<int>> loops(const ConvexPolyhedron& solid) {
    std::vector<std::vector<int>> faces;
    for (std::size_t f = 0; f < solid.planes.size(); ++f) {
        faces.emplace_back();
        for (int e = solid.face_begin[f]; e < solid.face_begin[f + 1]; ++e) {
            faces.back().push_back(solid.half_edges[static_cast<std::size_t>(e)].vertex);
        }
    }
    return faces;
}

/// The solid with its coordinates multiplied by positive factors.
inline ConvexPolyhedron stretched(const ConvexPolyhedron& solid, const Vec3& factors) {
    std::vector<Vec3> vertices = solid.vertices;
    for (Vec3& v : vertices) {
        v = v.cwiseProduct(factors);
    }
    return make_polyhedron(vertices, loops(solid));
}

inline ConvexPolyhedron scaled(const ConvexPolyhedron& solid, double factor) {
    return stretched(solid, Vec3::Constant(factor));
}

/// A prism on a regular polygon with corners at `radius` from the z axis.
inline ConvexPolyhedron regular_prism(int corners, double radius, double height) {
    std::vector<Vec3> vertices;
    std::vector<std::vector<int>> faces(2);
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        const Vec3 at(radius * std::cos(angle), radius * std::sin(angle), height / 2);
        vertices.push_back(at);
        vertices.emplace_back(at.x(), at.y(), -at.z());
        faces[0].push_back(2 * i);
        faces[1].push_back(2 * (corners - 1 - i) + 1);
        const int next = (i + 1) % corners;
        faces.push_back({2 * i, 2 * i + 1, 2 * next + 1, 2 * next});
    }
    return make_polyhedron(vertices, faces);
}

/// A regular icosahedron with corners at `radius` from the origin.
inline ConvexPolyhedron icosahedron(double radius) {
    const double b = radius / std::hypot(1, std::numbers::phi);
    const double a = b * std::numbers::phi;
    return make_polyhedron({{0, b, a},
                            {0, -b, a},
                            {0, b, -a},
                            {0, -b, -a},
                            {b, a, 0},
                            {-b, a, 0},
                            {b, -a, 0},
                            {-b, -a, 0},
                            {a, 0, b},
                            {-a, 0, b},
                            {a, 0, -b},
                            {-a, 0, -b}},
                           {{0, 1, 8}, {0, 9, 1},  {0, 5, 9},  {0, 4, 5},  {0, 8, 4},  {1, 6, 8},  {1, 7, 6},
                            {1, 9, 7}, {2, 10, 3}, {2, 3, 11}, {2, 11, 5}, {2, 5, 4},  {2, 4, 10}, {3, 10, 6},
                            {3, 6, 7}, {3, 7, 11}, {4, 8, 10}, {6, 10, 8}, {5, 11, 9}, {7, 9, 11}});
}

inline Quat turned(double angle, const Vec3& axis) {
    return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// The rotation with the vector `turn`: its angle [rad] along its axis.
inline Quat rotation(const Vec3& turn) {
    const double angle = turn.norm();
    return angle > 0 ? turned(angle, turn) : Quat::Identity();
}

}  // namespace scree::test
