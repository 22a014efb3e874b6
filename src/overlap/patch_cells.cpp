#include <scree/overlap/patch_cells.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree {

namespace {

constexpr double pi = std::numbers::pi;

/// Where the cells of a round patch of radius 1 are.
struct RoundCells {
    std::array<Vec2, PatchCells::count> direction;  // unit
    std::array<double, PatchCells::count> distance;

    RoundCells() {
        direction[0] = Vec2::UnitX();
        distance[0] = 0;
        std::size_t cell = 1;
        for (std::size_t ring = 1; ring <= PatchCells::rings; ++ring) {
            fill(ring, cell);
        }
    }

  private:
    // Every cell has the same area; it sits at its centroid.
    void fill(std::size_t ring, std::size_t& cell) {
        constexpr auto count = static_cast<double>(PatchCells::count);
        const std::size_t first = cell;
        const std::size_t members = 6 * ring;
        const double half = pi / static_cast<double>(members);
        const double inner = std::sqrt(static_cast<double>(first) / count);
        const double outer = std::sqrt(static_cast<double>(first + members) / count);
        const double middle =
            2.0 / 3 * (std::pow(outer, 3) - std::pow(inner, 3)) / (outer * outer - inner * inner);
        for (; cell < first + members; ++cell) {
            const double angle = half * static_cast<double>(2 * (cell - first) + ring % 2);
            direction[cell] = {std::cos(angle), std::sin(angle)};
            distance[cell] = middle * std::sin(half) / half;
        }
    }
};

/// Places the cells of a patch whose outline and depth are known. Returns false for one without extent.
bool place(const PatchOutline& outline, PatchCells& cells) {
    static const RoundCells round;
    const double own = 2.0 / 3 / std::sqrt(static_cast<double>(PatchCells::count));
    double load = 0;
    Vec2 middle = Vec2::Zero();
    for (std::size_t i = 0; i < PatchCells::count; ++i) {
        const double reach = outline.reach(round.direction[i]);
        cells.at[i] = round.distance[i] * reach * round.direction[i];
        cells.lever[i] = own * reach;
        cells.share[i] = reach * reach * outline.depth(cells.at[i]);
        load += cells.share[i];
        middle += cells.share[i] * cells.at[i];
    }
    if (!(load > 0) || !std::isfinite(load)) {
        return false;
    }
    middle /= load;
    for (std::size_t i = 0; i < PatchCells::count; ++i) {
        cells.share[i] /= load;
        cells.at[i] -= middle;
    }
    return true;
}

// To the moment that the load has as it is.
void stretch(double lever, PatchCells& cells) {
    double sum = 0;
    for (std::size_t i = 0; i < PatchCells::count; ++i) {
        sum += cells.share[i] * std::hypot(cells.at[i].norm(), cells.lever[i]);
    }
    const double factor = sum > 0 ? lever / sum : 1;
    for (std::size_t i = 0; i < PatchCells::count; ++i) {
        cells.at[i] *= factor;
        cells.lever[i] *= factor;
    }
}

}  // namespace

bool cut_into_cells(const ContactGeometry& g, const Pose& pose_a, OverlapWorkspace& workspace,
                    PatchCells& cells) {
    if (!workspace.solid || g.centre_line) {
        return false;
    }
    const Quat back = workspace.frame.orientation.conjugate();
    const Vec3 centre = back * (pose_a.position + g.centroid - workspace.frame.position);
    PatchOutline& outline = workspace.outline;
    outline.see(workspace.clipped, centre, back * cells.axis, back * g.normal);
    if (!outline.surrounds_origin() || !place(outline, cells)) {
        return false;
    }
    stretch(outline.loaded_lever(), cells);
    return true;
}

}  // namespace scree
