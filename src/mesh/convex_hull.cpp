#include <scree/mesh/convex_hull.hpp>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "flatten_faces.hpp"
#include "merge_faces.hpp"
#include "point_cloud.hpp"

namespace scree {

namespace {

constexpr double merge_tolerance = 1e-6;    // of the size
constexpr double planar_tolerance = 5e-13;  // of the size; the rest of 10⁻¹² is for rounding at assembly

/// The polyhedron of loops over some of the points.
ConvexPolyhedron assembled(const std::vector<Vec3>& points, std::vector<std::vector<int>> loops) {
    std::vector<int> number(points.size(), -1);
    for (const auto& loop : loops) {
        for (const int v : loop) {
            number[v] = 0;
        }
    }
    std::vector<Vec3> used;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (number[v] == 0) {
            number[v] = static_cast<int>(used.size());
            used.push_back(points[v]);
        }
    }
    for (auto& loop : loops) {
        std::transform(loop.begin(), loop.end(), loop.begin(), [&](int v) { return number[v]; });
    }
    return make_polyhedron(std::move(used), loops);
}

/// Which faces of a polyhedron of unit size have a vertex off their plane, or one of a neighbour above it.
std::vector<char> bent_faces(const ConvexPolyhedron& solid, double tolerance) {
    std::vector<char> bent(solid.planes.size(), 0);
    const auto height = [&](int face, int h) {
        const Plane& plane = solid.planes[face];
        return plane.normal.dot(solid.vertices[solid.half_edges[h].vertex]) - plane.offset;
    };
    for (int f = 0; f < solid.face_count(); ++f) {
        for (int h = solid.face_begin[f]; h < solid.face_begin[f + 1]; ++h) {
            if (height(f, h) < -tolerance) {
                bent[f] = 1;
            }
            const int g = solid.half_edges[h].across;
            for (int k = solid.face_begin[g]; k < solid.face_begin[g + 1]; ++k) {
                if (height(f, k) > tolerance) {
                    bent[f] = 1;
                    bent[g] = 1;
                }
            }
        }
    }
    return bent;
}

/// Faces that hold a vertex which had to move farther than the tolerance.
void add_strained(const std::vector<Vec3>& before, const std::vector<Vec3>& after,
                  const std::vector<std::vector<int>>& loops, double tolerance, std::vector<char>& faults) {
    for (std::size_t f = 0; f < loops.size(); ++f) {
        if (std::any_of(loops[f].begin(), loops[f].end(),
                        [&](int v) { return !((after[v] - before[v]).norm() <= tolerance); })) {
            faults[f] = 1;
        }
    }
}

/// Faults in what merging made, by face. A face that borders on a fault shares in it.
std::vector<char> find_faults(const std::vector<Vec3>& before, const std::vector<Vec3>& after,
                              const MergedFaces& faces, double size) {
    std::vector<char> faults;
    try {
        faults = bent_faces(assembled(after, faces.loops), planar_tolerance * size);
    } catch (const std::invalid_argument&) {
        return std::vector<char>(faces.loops.size(), 1);
    }
    add_strained(before, after, faces.loops, merge_tolerance * size, faults);
    std::vector<char> touched(before.size(), 0);
    for (std::size_t f = 0; f < faults.size(); ++f) {
        if (faults[f] != 0) {
            for (const int v : faces.loops[f]) {
                touched[v] = 1;
            }
        }
    }
    for (std::size_t f = 0; f < faults.size(); ++f) {
        if (std::any_of(faces.loops[f].begin(), faces.loops[f].end(),
                        [&](int v) { return touched[v] != 0; })) {
            faults[f] = 1;
        }
    }
    return faults;
}

/// Marks the triangles of merged faces with faults, to be kept as they are. False if there are none.
bool keep_apart(const MergedFaces& faces, const std::vector<char>& faults, std::vector<char>& keep) {
    bool changed = false;
    for (std::size_t f = 0; f < faults.size(); ++f) {
        if (faults[f] != 0) {
            for (const int t : faces.triangles[f]) {
                changed = changed || keep[t] == 0;
                keep[t] = 1;
            }
        }
    }
    return changed;
}

/// Vertices that did not move keep every digit.
ConvexHull placed_hull(const std::vector<Vec3>& points, const std::vector<Vec3>& unit,
                       const std::vector<Vec3>& moved, const MergedFaces& faces, const UnitFrame& frame) {
    ConvexHull hull;
    std::vector<Vec3> placed = points;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (moved[v] != unit[v]) {
            placed[v] = frame.centre + frame.scale * moved[v];
            hull.largest_move = std::max(hull.largest_move, (placed[v] - points[v]).norm());
        }
    }
    hull.solid = assembled(placed, faces.loops);
    return hull;
}

/// Merges faces, and takes apart again what cannot be made planar and convex. Nothing if faults remain.
std::optional<ConvexHull> merged_hull(const std::vector<Vec3>& points, const UnitFrame& frame,
                                      const std::vector<Triangle>& triangles) {
    const std::vector<Vec3> unit = frame.to_unit(points);
    const double size = frame.size / frame.scale;
    std::vector<char> keep(triangles.size(), 0);
    for (;;) {
        const MergedFaces faces = merge_faces(unit, triangles, keep, merge_tolerance * size);
        const std::vector<Vec3> moved = flattened(unit, faces.loops);
        const std::vector<char> faults = find_faults(unit, moved, faces, size);
        if (std::find(faults.begin(), faults.end(), 1) == faults.end()) {
            return placed_hull(points, unit, moved, faces, frame);
        }
        if (!keep_apart(faces, faults, keep)) {
            return std::nullopt;
        }
    }
}

}  // namespace

ConvexHull convex_hull(const std::vector<Vec3>& points) {
    constexpr int turns = 8;
    const UnitFrame frame = unit_frame(points);
    std::vector<Vec3> apart;
    for (const int i : thinned(points, merge_tolerance * frame.size)) {
        apart.push_back(points[i]);
    }
    for (int turn = 0; turn < turns; ++turn) {
        const std::vector<Triangle> triangles = hull_triangles(frame.to_unit(apart), turn);
        if (!triangles.empty()) {
            if (std::optional<ConvexHull> hull = merged_hull(apart, frame, triangles)) {
                return *std::move(hull);
            }
        }
    }
    throw std::invalid_argument("Qhull found no convex hull of the " + std::to_string(points.size()) +
                                " points");
}

}  // namespace scree
