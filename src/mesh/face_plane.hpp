#pragma once

#include <algorithm>
#include <vector>

#include <scree/mesh/vectors.hpp>

#include "loop_normal.hpp"

namespace scree {

/// A plane that can tilt and shift. Its three unknowns are the tilts about two axes, times the face's radius,
/// and the shift, so that all are lengths.
struct FacePlane {
    Vec3 middle = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
    Vec3 first = Vec3::UnitX();   // unit, in the plane
    Vec3 second = Vec3::UnitY();  // unit, in the plane
    double shift = 0;
    double radius = 0;

    [[nodiscard]] double height(const Vec3& p) const { return normal.dot(p - middle) - shift; }
    /// d height / d unknowns
    [[nodiscard]] Vec3 slope(const Vec3& p) const {
        return {first.dot(p - middle) / radius, second.dot(p - middle) / radius, -1};
    }
    void move(const Vec3& unknowns) {
        normal = (normal + (first * unknowns.x() + second * unknowns.y()) / radius).normalized();
        first = normal.unitOrthogonal();
        second = normal.cross(first);
        shift += unknowns.z();
    }
};

inline FacePlane plane_of(const std::vector<Vec3>& points, const std::vector<int>& loop) {
    FacePlane plane;
    for (const int v : loop) {
        plane.middle += points[v] / static_cast<double>(loop.size());
    }
    for (const int v : loop) {
        plane.radius = std::max(plane.radius, (points[v] - plane.middle).norm());
    }
    plane.normal = loop_normal(points, loop);
    plane.move(Vec3::Zero());
    return plane;
}

}  // namespace scree
