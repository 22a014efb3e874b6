#pragma once

#include <array>
#include <vector>

#include <scree/mesh/convex_polyhedron.hpp>

#include <tests/support/solids.hpp>

namespace scree::test {

using Tetrahedron = std::array<Vec3, 4>;

inline double volume_of(const Tetrahedron& t) {
    return std::abs((t[1] - t[0]).cross(t[2] - t[0]).dot(t[3] - t[0])) / 6;
}

/// Adds the part of a tetrahedron with normal·x ≤ offset to `kept`, cut into tetrahedra.
inline void keep_below(const Tetrahedron& t, const Plane& plane, std::vector<Tetrahedron>& kept) {
    std::vector<Vec3> in, out;
    std::vector<double> in_height, out_height;
    for (const Vec3& p : t) {
        const double height = plane.normal.dot(p) - plane.offset;
        (height <= 0 ? in : out).push_back(p);
        (height <= 0 ? in_height : out_height).push_back(height);
    }
    const auto cut = [&](std::size_t i, std::size_t o) -> Vec3 {
        return in[i] + in_height[i] / (in_height[i] - out_height[o]) * (out[o] - in[i]);
    };
    // Three corners and the three below them; any such wedge is three tetrahedra.
    const auto wedge = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                           const Vec3& f) {
        kept.insert(kept.end(), {{a, b, c, d}, {b, c, d, e}, {c, d, e, f}});
    };
    if (out.empty()) {
        kept.push_back(t);
    } else if (in.size() == 3) {
        wedge(in[0], in[1], in[2], cut(0, 0), cut(1, 0), cut(2, 0));
    } else if (in.size() == 2) {
        wedge(in[0], cut(0, 0), cut(0, 1), in[1], cut(1, 0), cut(1, 1));
    } else if (in.size() == 1) {
        kept.push_back({in[0], cut(0, 0), cut(0, 1), cut(0, 2)});
    }
}

struct VolumeAndCentroid {
    double volume = 0;
    Vec3 centroid = Vec3::Zero();
};

/// A ∩ B: tetrahedra of A from its middle to its faces, each cut into tetrahedra by all planes of B.
inline VolumeAndCentroid brute_force_intersection(const ConvexPolyhedron& a, const ConvexPolyhedron& b) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& v : a.vertices) {
        middle += v / static_cast<double>(a.vertices.size());
    }
    VolumeAndCentroid sum;
    for (const std::vector<int>& face : loops(a)) {
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const auto corner = [&](std::size_t k) { return a.vertices[static_cast<std::size_t>(face[k])]; };
            std::vector<Tetrahedron> parts{{middle, corner(0), corner(i), corner(i + 1)}};
            for (const Plane& plane : b.planes) {
                std::vector<Tetrahedron> kept;
                for (const Tetrahedron& part : parts) {
                    keep_below(part, plane, kept);
                }
                parts.swap(kept);
            }
            for (const Tetrahedron& part : parts) {
                sum.volume += volume_of(part);
                sum.centroid += volume_of(part) * (part[0] + part[1] + part[2] + part[3]) / 4;
            }
        }
    }
    if (sum.volume > 0) {
        sum.centroid /= sum.volume;
    }
    return sum;
}

/// The part of a polygon with normal·x ≤ offset.
inline std::vector<Vec3> clip_polygon(const std::vector<Vec3>& polygon, const Plane& plane) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& here = polygon[i];
        const Vec3& next = polygon[(i + 1) % polygon.size()];
        const double h = plane.normal.dot(here) - plane.offset;
        const double k = plane.normal.dot(next) - plane.offset;
        if (h <= 0) {
            kept.push_back(here);
        }
        if ((h <= 0) != (k <= 0)) {
            kept.emplace_back(here + h / (h - k) * (next - here));
        }
    }
    return kept;
}

/// Calls visit(point, outward normal times area) at the points of a rule, exact for quadratic integrands,
/// over A's surface inside B. For faces in general position: none of A's in one plane with one of B's.
template <class Visit>
void for_surface_inside(const ConvexPolyhedron& a, const ConvexPolyhedron& b, Visit&& visit) {
    for (const std::vector<int>& face : loops(a)) {
        std::vector<Vec3> polygon;
        for (const int v : face) {
            polygon.push_back(a.vertices[static_cast<std::size_t>(v)]);
        }
        for (const Plane& plane : b.planes) {
            polygon = clip_polygon(polygon, plane);
        }
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
            const Vec3& p = polygon[0];
            const Vec3& q = polygon[i];
            const Vec3& r = polygon[i + 1];
            const Vec3 third = (q - p).cross(r - p) / 6;
            visit(Vec3(0.5 * (p + q)), third);
            visit(Vec3(0.5 * (q + r)), third);
            visit(Vec3(0.5 * (r + p)), third);
        }
    }
}

}  // namespace scree::test
