#pragma once

#include <scree/overlap/overlap.hpp>

namespace scree {

bool overlap_cap(const Sphere& a, const Pose& pose_a, const HalfSpace& b, const Pose& pose_b,
                 ContactGeometry& geometry);

bool overlap_lens(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b,
                  ContactGeometry& geometry);

}  // namespace scree
