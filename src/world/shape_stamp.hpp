#pragma once

#include <btBulletCollisionCommon.h>

#include <cstdint>

namespace scree {

/// A number that changes when somebody scales a shape, sets its margin, or adds, removes, moves or changes
/// children of a compound, all of which Bullet allows while a body has it.
std::uint64_t shape_stamp(const btCollisionShape& shape);

}  // namespace scree
