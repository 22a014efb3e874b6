#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <scree/mesh/convex_polyhedron.hpp>

namespace scree::test {

/// The corners of the cube of edge 1 about the origin.
inline std::vector<Vec3> cube_corners() {
    return make_box(Vec3::Ones()).vertices;
}

/// Two regular polygons of radius 1, one above the other.
inline std::vector<Vec3> prism_corners(int sides, double height = 1) {
    std::vector<Vec3> corners;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        corners.emplace_back(std::cos(angle), std::sin(angle), height / 2);
        corners.emplace_back(std::cos(angle), std::sin(angle), -height / 2);
    }
    return corners;
}

/// Twelve rhombi; four of them meet at six of the corners. Its edges are √3 long, its volume is 16.
inline std::vector<Vec3> rhombic_dodecahedron_corners() {
    std::vector<Vec3> corners;
    for (const Vec3& corner : cube_corners()) {
        corners.emplace_back(2 * corner);
    }
    for (int axis = 0; axis < 3; ++axis) {
        corners.emplace_back(2 * Vec3::Unit(axis));
        corners.emplace_back(-2 * Vec3::Unit(axis));
    }
    return corners;
}

/// Evenly spread points on the unit sphere, none of four in a plane.
inline std::vector<Vec3> spiral_sphere(int count) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2.0 * i + 1) / count;
        const double angle = 2.399963229728653 * i;
        const double r = std::sqrt(1 - z * z);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    return points;
}

/// The points after a rotation, then a scaling, then a shift.
inline std::vector<Vec3> turned(std::vector<Vec3> points, const Quat& rotation, double scale = 1,
                                const Vec3& shift = Vec3::Zero()) {
    for (Vec3& p : points) {
        p = scale * (rotation * p) + shift;
    }
    return points;
}

/// The points as a file in single precision holds them.
inline std::vector<Vec3> as_float(std::vector<Vec3> points) {
    for (Vec3& p : points) {
        p = p.cast<float>().cast<double>();
    }
    return points;
}

/// The largest extent along an axis.
inline double size_of(const std::vector<Vec3>& points) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : points) {
        box.extend(p);
    }
    return box.sizes().maxCoeff();
}

/// How far a point is above the planes of a solid at most; negative inside.
inline double height_above(const ConvexPolyhedron& solid, const std::vector<Vec3>& points) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Plane& plane : solid.planes) {
        for (const Vec3& p : points) {
            highest = std::max(highest, plane.normal.dot(p) - plane.offset);
        }
    }
    return highest;
}

/// How far a vertex is below the plane of a face that it belongs to, at most.
inline double unevenness(const ConvexPolyhedron& solid) {
    double deepest = 0;
    for (int f = 0; f < solid.face_count(); ++f) {
        for (int h = solid.face_begin[f]; h < solid.face_begin[f + 1]; ++h) {
            const Vec3& p = solid.vertices[solid.half_edges[h].vertex];
            deepest = std::max(deepest, solid.planes[f].offset - solid.planes[f].normal.dot(p));
        }
    }
    return deepest;
}

}  // namespace scree::test
