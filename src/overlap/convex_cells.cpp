#include <scree/overlap/convex_cells.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <scree/mesh/convex_hull.hpp>
#include <scree/overlap/clip.hpp>

#include "patch.hpp"

namespace scree {

namespace {

constexpr double thin = 1e-9;  // of the mesh's size, that counts as nothing

using Polygon = std::vector<Vec3>;

/// A piece of the mesh's surface inside a cell.
struct Sheet {
    Polygon corners;
    Plane plane;
};

/// A convex part of space and what of the surface lies in it.
struct Cell {
    ClippedSolid solid;
    std::vector<Sheet> sheets;
};

// The part of a polygon below a plane.
Polygon below(const Polygon& polygon, const Plane& plane) {
    Polygon left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& here = polygon[i];
        const Vec3& next = polygon[(i + 1) % polygon.size()];
        const double height = plane.normal.dot(here) - plane.offset;
        const double next_height = plane.normal.dot(next) - plane.offset;
        if (height <= 0) {
            left.push_back(here);
        }
        if ((height < 0 && next_height > 0) || (height > 0 && next_height < 0)) {
            left.push_back(here + height / (height - next_height) * (next - here));
        }
    }
    return left;
}

class Cutter {
  public:
    Cutter(const TriangleMesh& mesh, std::size_t most) : mesh_(mesh), most_(most) {}

    std::vector<ConvexPolyhedron> run() {
        const ConvexPolyhedron hull = convex_hull(mesh_.vertices).solid;
        least_ = thin * hull.radius;
        cut_at_ = 8 * most_;
        Cell whole;
        whole.solid.start(hull);
        for (const auto& [a, b, c] : mesh_.triangles) {
            add_sheet({vertex(a), vertex(b), vertex(c)}, hull, whole);
        }
        divide(std::move(whole));
        return given_up_ ? std::vector<ConvexPolyhedron>() : std::move(cells_);
    }

  private:
    [[nodiscard]] const Vec3& vertex(int number) const {
        return mesh_.vertices[static_cast<std::size_t>(number)];
    }

    // A triangle that is not on the hull.
    void add_sheet(const Polygon& corners, const ConvexPolyhedron& hull, Cell& cell) const {
        const Vec3 area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        const double size = area.norm();
        if (size <= least_ * least_) {
            return;
        }
        const Plane plane{area / size, area.dot(corners[0]) / size};
        const bool outside = std::any_of(hull.planes.begin(), hull.planes.end(),
                                         [&](const Plane& side) { return on(corners, side); });
        if (!outside) {
            cell.sheets.push_back({corners, plane});
        }
    }

    [[nodiscard]] bool on(const Polygon& polygon, const Plane& plane) const {
        return std::all_of(polygon.begin(), polygon.end(), [&](const Vec3& corner) {
            return std::abs(plane.normal.dot(corner) - plane.offset) <= least_;
        });
    }

    void divide(Cell cell) {
        if (given_up_) {
            return;
        }
        if (cell.sheets.empty()) {
            keep(cell.solid);
            return;
        }
        given_up_ = --cut_at_ == 0 || cells_.size() > most_;
        const Plane plane = best_plane(cell);
        const Plane other{-plane.normal, -plane.offset};
        divide(part(cell, plane));
        divide(part(cell, other));
    }

    [[nodiscard]] Cell part(const Cell& cell, const Plane& plane) const {
        Cell half;
        half.solid = cell.solid;
        if (!half.solid.cut(plane, 0)) {
            return {};
        }
        for (const Sheet& sheet : cell.sheets) {
            if (on(sheet.corners, plane)) {
                continue;
            }
            Polygon left = below(sheet.corners, plane);
            const double deepest = left.empty() ? 0 : depth(left, plane);
            if (left.size() >= 3 && deepest > least_) {
                half.sheets.push_back({std::move(left), sheet.plane});
            }
        }
        return half;
    }

    static double depth(const Polygon& polygon, const Plane& plane) {
        double most = 0;
        for (const Vec3& corner : polygon) {
            most = std::max(most, plane.offset - plane.normal.dot(corner));
        }
        return most;
    }

    // That which cuts through the fewest of the other sheets, and of those settles the most.
    [[nodiscard]] Plane best_plane(const Cell& cell) const {
        const Plane* best = nullptr;
        long least = 0;
        for (const Sheet& candidate : cell.sheets) {
            long score = 0;
            for (const Sheet& sheet : cell.sheets) {
                const Plane& plane = candidate.plane;
                const Plane other{-plane.normal, -plane.offset};
                const bool lies_in = on(sheet.corners, plane);
                const bool crossed =
                    !lies_in && depth(sheet.corners, plane) > least_ && depth(sheet.corners, other) > least_;
                score += crossed ? 4 : (lies_in ? -1 : 0);
            }
            if (best == nullptr || score < least) {
                best = &candidate.plane;
                least = score;
            }
        }
        return *best;
    }

    void keep(const ClippedSolid& solid) {
        if (solid.vertices().empty()) {
            return;
        }
        ContactGeometry whole;
        integrate_volume(solid, whole);
        if (!(whole.volume > least_ * least_ * least_) || !inside(whole.centroid)) {
            return;
        }
        Polygon corners;
        for (const int number : solid.vertices()) {
            corners.push_back(solid.point(number));
        }
        try {
            cells_.push_back(convex_hull(corners).solid);
        } catch (const std::invalid_argument&) {
            // too thin to be a solid
        }
    }

    // By the solid angle of the surface.
    [[nodiscard]] bool inside(const Vec3& point) const {
        double angle = 0;
        for (const auto& [a, b, c] : mesh_.triangles) {
            const Vec3 p = vertex(a) - point;
            const Vec3 q = vertex(b) - point;
            const Vec3 r = vertex(c) - point;
            const double below = p.norm() * q.norm() * r.norm() + p.dot(q) * r.norm() + q.dot(r) * p.norm() +
                                 r.dot(p) * q.norm();
            angle += 2 * std::atan2(p.dot(q.cross(r)), below);
        }
        return angle > 2 * std::numbers::pi;
    }

    const TriangleMesh& mesh_;
    std::size_t most_;
    std::size_t cut_at_ = 0;  ///< cuts that are left
    double least_ = 0;        ///< [m]
    bool given_up_ = false;
    std::vector<ConvexPolyhedron> cells_;
};

}  // namespace

std::vector<ConvexPolyhedron> convex_cells(const TriangleMesh& mesh, std::size_t most) {
    return Cutter(mesh, most).run();
}

}  // namespace scree
