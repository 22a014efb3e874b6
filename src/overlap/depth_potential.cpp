#include <scree/overlap/depth_potential.hpp>

#include <algorithm>

#include "patch.hpp"
#include "polyhedron_overlap.hpp"

namespace scree {

namespace {

// Tags of the faces between two cells start here; the rest is the place of the other cell's face.
constexpr int cell_tags = 1 << 25;

// Below this difference of their normals two faces count as parallel, and a face between their cells as no
// faster than at this angle.
constexpr double least_difference = 1e-6;
constexpr double slowest_difference = 1e-3;

const Vec3& corner(const ClippedSolid& solid, int half_edge) {
    return solid.point(solid.half_edges()[static_cast<std::size_t>(half_edge)].vertex);
}

/// The sides of the overlap and the cells that belong to them, in the frame of the clipped solid.
class Cells {
  public:
    Cells(const ConvexPolyhedron& a, const Vec3& centroid, OverlapWorkspace& workspace)
        : workspace_(workspace), centroid_(centroid) {
        const OverlapPlanes planes{a.planes, workspace.planes};
        workspace.sides.clear();
        for (const ClippedSolid::Face& face : workspace.clipped.faces()) {
            const bool known = std::any_of(workspace.sides.begin(), workspace.sides.end(),
                                           [&](const auto& side) { return side.tag == face.tag; });
            if (!known) {
                workspace.sides.push_back({planes.plane(face.tag), face.tag});
            }
        }
    }

    [[nodiscard]] std::size_t count() const { return workspace_.sides.size(); }
    [[nodiscard]] bool of_b(std::size_t side) const { return workspace_.sides[side].tag >= cut_tags; }
    [[nodiscard]] const Vec3& normal(std::size_t side) const { return workspace_.sides[side].plane.normal; }

    /// Leaves the cell of a side in the workspace. Returns false when there is none.
    bool cut(std::size_t side) {
        workspace_.cell = workspace_.clipped;
        for (std::size_t other = 0; other < count(); ++other) {
            if (other != side && !keep_nearer(side, other)) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] const ClippedSolid& cell() const { return workspace_.cell; }
    [[nodiscard]] const Vec3& centroid() const { return centroid_; }

  private:
    // Of what is left, the part that is nearer to one side than to another.
    bool keep_nearer(std::size_t side, std::size_t other) {
        const Plane& near = workspace_.sides[side].plane;
        const Plane& far = workspace_.sides[other].plane;
        const Vec3 difference = far.normal - near.normal;
        const double size = difference.norm();
        if (size < least_difference) {
            const double by =
                (near.offset - near.normal.dot(centroid_)) - (far.offset - far.normal.dot(centroid_));
            return by < 0 || (by == 0 && side < other);
        }
        return workspace_.cell.cut({difference / size, (far.offset - near.offset) / size},
                                   cell_tags + static_cast<int>(other));
    }

    OverlapWorkspace& workspace_;
    Vec3 centroid_;
};

// A boundary between a cell of B and one of A moves with A's face; what it sweeps changes sides.
void add_boundaries(const Cells& cells, std::size_t side, Mat6& rate) {
    const ClippedSolid& cell = cells.cell();
    for (const ClippedSolid::Face& face : cell.faces()) {
        if (face.tag < cell_tags) {
            continue;
        }
        const auto other = static_cast<std::size_t>(face.tag - cell_tags);
        if (cells.of_b(other)) {
            continue;
        }
        const Vec3& gained = cells.normal(side);
        const Vec3& moved = cells.normal(other);
        const Vec3 first = corner(cell, face.begin) - cells.centroid();
        const double slowness = 1 / std::max((moved - gained).norm(), slowest_difference);
        for (int e = face.begin + 1; e + 1 < face.end; ++e) {
            const Vec3 second = corner(cell, e) - cells.centroid();
            const Vec3 third = corner(cell, e + 1) - cells.centroid();
            const double weight = slowness / 3 * (second - first).cross(third - first).norm();
            for (const Vec3& r :
                 {Vec3(0.5 * (first + second)), Vec3(0.5 * (second + third)), Vec3(0.5 * (third + first))}) {
                Eigen::Matrix<double, 6, 1> gain, motion;
                gain << gained, r.cross(gained);
                motion << moved, r.cross(moved);
                rate.noalias() += weight * gain * motion.transpose();
            }
        }
    }
}

void rotate(DepthPotential& potential, const Mat3& turn) {
    potential.force = turn * potential.force;
    potential.moment = turn * potential.moment;
    for (int row = 0; row < 6; row += 3) {
        for (int column = 0; column < 6; column += 3) {
            const Mat3 block = potential.rate.block<3, 3>(row, column);
            potential.rate.block<3, 3>(row, column) = turn * block * turn.transpose();
        }
    }
}

}  // namespace

void depth_potential(const ConvexPolyhedron& a, const Pose& pose_a, const ContactGeometry& geometry,
                     Detail detail, OverlapWorkspace& workspace, DepthPotential& potential) {
    potential = DepthPotential{};
    const Vec3 centroid = pose_a.orientation.conjugate() * geometry.centroid;
    Cells cells(a, centroid, workspace);
    for (std::size_t side = 0; side < cells.count(); ++side) {
        ContactGeometry part;
        if (!cells.cut(side)) {
            continue;
        }
        integrate_volume(cells.cell(), part);
        const Vec3 arm = part.centroid - centroid;
        // ∫ e dV by the divergence theorem: e is 0 all round, and falls off along the normal with the
        // slope 2.
        potential.value += 2.0 / 3 * part.volume * arm.dot(cells.normal(side));
        if (cells.of_b(side)) {
            const Vec3 push = 2 * part.volume * cells.normal(side);
            potential.force += push;
            potential.moment += arm.cross(push);
            if (detail == Detail::derivative) {
                add_boundaries(cells, side, potential.rate);
            }
        }
    }
    rotate(potential, pose_a.orientation.toRotationMatrix());
}

}  // namespace scree
