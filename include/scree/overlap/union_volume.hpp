#pragma once

#include <span>

#include <scree/mesh/convex_polyhedron.hpp>

namespace scree {

/// The volume [m³] that convex solids fill together, what several of them share counted once; all in one
/// frame.
double union_volume(std::span<const ConvexPolyhedron> solids);

}  // namespace scree
