#include "shape_stamp.hpp"

#include <bit>

namespace scree {

namespace {

/// FNV-1a, by words.
class Hash {
  public:
    void add(std::uint64_t word) { value_ = (value_ ^ word) * 1099511628211U; }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(const btVector3& v) {
        add(v.x());
        add(v.y());
        add(v.z());
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 14695981039346656037U;
};

void add_children(const btCompoundShape& compound, Hash& hash) {
    for (int i = 0; i < compound.getNumChildShapes(); ++i) {
        const btTransform& place = compound.getChildTransform(i);
        hash.add(place.getOrigin());
        for (int row = 0; row < 3; ++row) {
            hash.add(place.getBasis()[row]);
        }
        hash.add(shape_stamp(*compound.getChildShape(i)));
    }
}

}  // namespace

std::uint64_t shape_stamp(const btCollisionShape& shape) {
    Hash hash;
    hash.add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(&shape)));
    hash.add(shape.getLocalScaling());
    hash.add(shape.getMargin());
    if (shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE) {
        hash.add(static_cast<std::uint64_t>(static_cast<const btConvexHullShape&>(shape).getNumPoints()));
    }
    if (shape.isCompound()) {
        add_children(static_cast<const btCompoundShape&>(shape), hash);
    }
    return hash.value();
}

}  // namespace scree
