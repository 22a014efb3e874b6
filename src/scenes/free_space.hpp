#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <scree/overlap/overlap.hpp>

namespace scree {

/// Where bodies stand, and whether another one would have room. Bodies of up to a few cells' size are found
/// by a grid; larger ones are always asked.
class FreeSpace {
  public:
    /// The edge of the grid's cells [m]: about the size of the bodies that are many.
    explicit FreeSpace(double cell) : cell_(cell) {}

    /// The shape must outlive this.
    void add(const Shape& shape, const Pose& pose);
    /// Whether a shape would overlap none of those added.
    [[nodiscard]] bool has_room(const Shape& shape, const Pose& pose);

  private:
    struct Placed {
        const Shape* shape = nullptr;
        Pose pose;
        double radius = 0;  ///< [m]
    };
    using Cell = std::uint64_t;

    template <class Visit>
    void visit_cells(const Vec3& centre, double radius, const Visit& visit) const;
    bool clear(const Placed& a, const Placed& b);

    double cell_;
    std::vector<Placed> placed_;
    std::vector<std::size_t> large_;                              ///< numbers in placed_
    std::unordered_map<Cell, std::vector<std::size_t>> by_cell_;  ///< likewise
    OverlapWorkspace workspace_;
};

}  // namespace scree
