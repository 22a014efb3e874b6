#pragma once

#include <utility>

#include <scree/mesh/vectors.hpp>

namespace scree {

/// The principal moments of an inertia and the rotation from the principal frame to the given one. Of the
/// many frames that serve, the one nearest to the given frame, so that a body whose inertia is diagonal keeps
/// its axes, and equal moments leave no choice to rounding.
std::pair<Vec3, Quat> principal_axes(const Mat3& inertia);

}  // namespace scree
