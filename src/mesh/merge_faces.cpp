#include "merge_faces.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "coplanar_region.hpp"

namespace scree {

namespace {

using Loop = std::vector<int>;

/// The large triangles first: their planes are the best known.
std::vector<int> by_area(const CoplanarRegion& regions, std::size_t count) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return regions.area(a) > regions.area(b); });
    return order;
}

/// How many faces meet at each vertex.
std::vector<int> face_counts(const std::vector<Loop>& loops, std::size_t vertices) {
    std::vector<int> counts(vertices, 0);
    for (const Loop& loop : loops) {
        for (const int v : loop) {
            ++counts[v];
        }
    }
    return counts;
}

/// A vertex between two faces only lies on their common edge and bounds nothing.
void remove_edge_vertices(std::vector<Loop>& loops, std::size_t vertices) {
    const std::vector<int> counts = face_counts(loops, vertices);
    for (Loop& loop : loops) {
        std::erase_if(loop, [&](int v) { return counts[v] < 3; });
    }
}

}  // namespace

MergedFaces merge_faces(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                        const std::vector<char>& keep, double tolerance) {
    CoplanarRegion regions(points, triangles, tolerance);
    std::vector<char> taken = keep;
    MergedFaces faces;
    const auto add = [&](Loop loop, std::vector<int> members) {
        for (const int t : members) {
            taken[t] = 1;
        }
        faces.loops.push_back(std::move(loop));
        faces.triangles.push_back(std::move(members));
    };
    for (const int seed : by_area(regions, triangles.size())) {
        const Loop own(triangles[seed].begin(), triangles[seed].end());
        if (keep[seed] != 0) {
            add(own, {seed});
        } else if (taken[seed] == 0) {
            std::vector<int> region = regions.grown(seed, taken);
            Loop border = regions.border(region);
            if (border.size() >= 3) {
                add(std::move(border), std::move(region));
            } else {
                add(own, {seed});
            }
        }
    }
    remove_edge_vertices(faces.loops, points.size());
    return faces;
}

}  // namespace scree
