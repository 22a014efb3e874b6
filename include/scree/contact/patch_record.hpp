#pragma once

#include <bitset>

#include <scree/mesh/saved_state.hpp>
#include <scree/overlap/patch_cells.hpp>

namespace scree {

/// The tangential state of every cell of a patch, in the patch's axes: what the friction on A would be if all
/// cells were as this one.
struct PatchRecord {
    Vec3 axis = Vec3::UnitX();  ///< the first of the patch's axes, in world axes of its own time
    /// Along the axes, and the moment over the cell's own lever [N].
    std::array<Vec3, PatchCells::count> force;
    std::bitset<PatchCells::count> slipping;  ///< those that were at their limit
};
void visit_state(auto& with, StateOf<PatchRecord> auto& record) {
    auto& [axis, force, slipping] = record;
    with(axis, force, slipping);
}

}  // namespace scree
