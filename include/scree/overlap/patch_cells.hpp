#pragma once

#include <array>

#include <scree/overlap/overlap.hpp>

namespace scree {

/// A patch of contact cut into cells of next to equal area: one about the centroid, and rings about that
/// which follow the outline of the overlap as it is seen along the normal. Each has the share of the load
/// that the overlap's depth there gives it. The axes are `axis` and n × `axis`, the origin is the centroid:
/// the shares' sum is 1, their first moment 0, and the moment of a spin, Σ share √(‖at‖² + lever²), is ∫‖p−c‖
/// depth dA/V.
struct PatchCells {
    static constexpr std::size_t rings = 4;                            ///< about the middle cell
    static constexpr std::size_t count = 1 + 3 * rings * (rings + 1);  ///< 1 + 6 + 12 + 18 + 24

    Vec3 axis = Vec3::UnitX();        ///< unit, across the normal
    std::array<Vec2, count> at;       ///< [m]
    std::array<double, count> share;  ///< of the normal force, dimensionless
    std::array<double, count> lever;  ///< [m], ∫‖p−at‖dA/A of the cell itself
};

/// Cuts up the last overlap that the workspace was used for. Fills all but `axis`, which it reads. Returns
/// false where that has left no solid, as of two spheres, or S vanishes. `pose_a`: of A's shape.
bool cut_into_cells(const ContactGeometry& geometry, const Pose& pose_a, OverlapWorkspace& workspace,
                    PatchCells& cells);

}  // namespace scree
