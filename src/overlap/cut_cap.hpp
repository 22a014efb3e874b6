#pragma once

#include <scree/overlap/overlap.hpp>

namespace scree {

/// The part of a ball below a plane and, of that, the part beyond another plane through the ball's centre:
/// what the round end of a capsule shares with flat ground. The second plane is an interface to the rest of
/// the capsule; it counts as A's surface here, and the rest has the same with the opposite sign.
struct CutCap {
    double radius = 0;  ///< [m]
    Vec3 end;           ///< unit, out of the capsule along its axis
    Vec3 normal;        ///< unit, out of the ground
    double height = 0;  ///< [m], of the ball's centre above the ground; below −radius it counts as that
};

/// The geometry of A's ball against the ground, world axes, origin at the ball's centre. Returns false when
/// there is nothing.
bool overlap_cut_cap(const CutCap& cap, Detail detail, ContactGeometry& geometry);

/// The volume [m³] without the second plane.
double whole_volume(const CutCap& cap);

}  // namespace scree
