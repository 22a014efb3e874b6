#include "free_space.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double large = 4;  // cells; above that a body would be in too many

/// The core has no overlap of a sphere with a polyhedron: the sphere is clear of it when it is outside of one
/// of its faces. At edges that keeps a little more room than needed.
bool clear_of_faces(const ConvexPolyhedron& solid, const Pose& pose, const Vec3& centre, double radius) {
    const Vec3 local = pose.inverse() * centre;
    return std::any_of(solid.planes.begin(), solid.planes.end(),
                       [&](const Plane& plane) { return plane.normal.dot(local) - plane.offset >= radius; });
}

std::uint64_t cell_key(const std::array<std::int64_t, 3>& cell) {
    std::uint64_t key = 0;
    for (const std::int64_t i : cell) {
        key = (key << 21) | (static_cast<std::uint64_t>(i) & 0x1fffff);  // cells far apart may share a key
    }
    return key;
}

}  // namespace

template <class Visit>
void FreeSpace::visit_cells(const Vec3& centre, double radius, const Visit& visit) const {
    std::array<std::int64_t, 3> low{};
    std::array<std::int64_t, 3> high{};
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::llround(std::floor((centre[axis] - radius) / cell_));
        high[axis] = std::llround(std::floor((centre[axis] + radius) / cell_));
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
            for (std::int64_t z = low[2]; z <= high[2]; ++z) {
                visit(cell_key({x, y, z}));
            }
        }
    }
}

void FreeSpace::add(const Shape& shape, const Pose& pose) {
    const std::size_t number = placed_.size();
    placed_.push_back({&shape, pose, bounding_radius(shape)});
    if (!(placed_.back().radius <= large * cell_)) {
        large_.push_back(number);
        return;
    }
    visit_cells(pose.position, placed_.back().radius, [&](Cell cell) { by_cell_[cell].push_back(number); });
}

bool FreeSpace::has_room(const Shape& shape, const Pose& pose) {
    const Placed body{&shape, pose, bounding_radius(shape)};
    const auto all_clear = [&](const std::vector<std::size_t>& others) {
        return std::all_of(others.begin(), others.end(),
                           [&](std::size_t i) { return clear(placed_[i], body); });
    };
    bool room = all_clear(large_);
    visit_cells(pose.position, body.radius, [&](Cell cell) {
        const auto found = by_cell_.find(cell);
        room = room && (found == by_cell_.end() || all_clear(found->second));
    });
    return room;
}

bool FreeSpace::clear(const Placed& a, const Placed& b) {
    if ((a.pose.position - b.pose.position).norm() >= a.radius + b.radius) {
        return true;
    }
    const auto* solid_a = std::get_if<ConvexPolyhedron>(a.shape);
    const auto* solid_b = std::get_if<ConvexPolyhedron>(b.shape);
    if (solid_a != nullptr && std::holds_alternative<Sphere>(*b.shape)) {
        return clear_of_faces(*solid_a, a.pose, b.pose.position, b.radius);
    }
    if (solid_b != nullptr && std::holds_alternative<Sphere>(*a.shape)) {
        return clear_of_faces(*solid_b, b.pose, a.pose.position, a.radius);
    }
    ContactGeometry geometry;
    return !overlap(*a.shape, a.pose, *b.shape, b.pose, Detail::force, false, workspace_, geometry);
}

}  // namespace scree
