#include "coplanar_region.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <Eigen/Eigenvalues>

namespace scree {

struct CoplanarRegion::FittedPlane {
    Vec3 point;
    Vec3 normal;

    [[nodiscard]] double height(const Vec3& p) const { return normal.dot(p - point); }
};

CoplanarRegion::CoplanarRegion(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                               double tolerance)
    : points_(points), triangles_(triangles), tolerance_(tolerance), marked_(triangles.size(), 0) {
    edges_.reserve(3 * triangles.size());
    area_.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        area_.emplace_back((points[b] - points[a]).cross(points[c] - points[a]) / 2);
        for (int i = 0; i < 3; ++i) {
            edges_.add(triangles[t][i], triangles[t][(i + 1) % 3], static_cast<int>(t));
        }
    }
}

bool CoplanarRegion::fits(int triangle, const FittedPlane& plane) const {
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
        const Vec3& p = points_[triangles_[triangle][i]];
        if (std::abs(plane.height(p)) > tolerance_) {
            return false;
        }
        longest = std::max(longest, (p - points_[triangles_[triangle][(i + 1) % 3]]).norm());
    }
    // A sliver's normal is noise; any other triangle must face the same way, or it lies beyond a sharp edge.
    return area(triangle) <= tolerance_ * longest || area_[triangle].dot(plane.normal) > 0.5 * area(triangle);
}

std::vector<int> CoplanarRegion::connected(int seed, const FittedPlane& plane,
                                           const std::vector<char>& taken) {
    std::vector<int> region{seed};
    marked_[seed] = ++mark_;
    for (std::size_t i = 0; i < region.size(); ++i) {
        const Triangle corners = triangles_[region[i]];
        for (int k = 0; k < 3; ++k) {
            const int next = edges_.owner(corners[(k + 1) % 3], corners[k]);
            if (next != DirectedEdges::none && marked_[next] != mark_ && taken[next] == 0 &&
                fits(next, plane)) {
                marked_[next] = mark_;
                region.push_back(next);
            }
        }
    }
    return region;
}

/// By least squares over the vertices.
CoplanarRegion::FittedPlane CoplanarRegion::fitted(const std::vector<int>& region,
                                                   const Vec3& outward) const {
    Vec3 middle = Vec3::Zero();
    for (const int t : region) {
        for (const int v : triangles_[t]) {
            middle += points_[v] / static_cast<double>(3 * region.size());
        }
    }
    Mat3 spread = Mat3::Zero();
    for (const int t : region) {
        for (const int v : triangles_[t]) {
            spread += (points_[v] - middle) * (points_[v] - middle).transpose();
        }
    }
    const Vec3 normal = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(0);
    return {middle, normal.dot(outward) < 0 ? Vec3(-normal) : normal};
}

// First against the seed's own plane, then against the plane of what was found, as long as that finds more: a
// small seed's plane does not reach across a large face whose vertices carry the file's rounding.
std::vector<int> CoplanarRegion::grown(int seed, const std::vector<char>& taken) {
    constexpr int most_passes = 30;
    if (area(seed) == 0) {
        return {seed};
    }
    const Vec3 outward = area_[seed] / area(seed);
    std::vector<int> region = connected(seed, {points_[triangles_[seed][0]], outward}, taken);
    for (int pass = 0; pass < most_passes && region.size() > 1; ++pass) {
        const FittedPlane plane = fitted(region, outward);
        if (!fits(seed, plane)) {
            break;
        }
        std::vector<int> wider = connected(seed, plane, taken);
        if (wider.size() <= region.size()) {
            break;
        }
        region = std::move(wider);
    }
    return region;
}

std::vector<int> CoplanarRegion::border(const std::vector<int>& region) {
    ++mark_;
    for (const int t : region) {
        marked_[t] = mark_;
    }
    std::unordered_map<int, int> next;
    int first = -1;
    for (const int t : region) {
        for (int i = 0; i < 3; ++i) {
            const int from = triangles_[t][i];
            const int to = triangles_[t][(i + 1) % 3];
            const int across = edges_.owner(to, from);
            if (across != DirectedEdges::none && marked_[across] == mark_) {
                continue;
            }
            if (!next.emplace(from, to).second) {
                return {};  // the border touches itself
            }
            first = from;
        }
    }
    std::vector<int> loop;
    for (int v = first; loop.size() < next.size() && (loop.empty() || v != first); v = next.at(v)) {
        loop.push_back(v);
    }
    return loop.size() == next.size() ? loop : std::vector<int>{};
}

}  // namespace scree
