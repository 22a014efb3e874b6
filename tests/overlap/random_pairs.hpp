#pragma once

#include <cmath>
#include <vector>

#include <tests/support/random.hpp>
#include <tests/support/solids.hpp>

namespace scree::test {

/// Convex solids of all sorts, some nasty: generic hulls, hulls of points on a coarse grid, boxes, prisms,
/// plates and needles down to 10⁻⁶ of their length.
class SolidPool {
  public:
    explicit SolidPool(Random& random) {
        for (int i = 0; i < 60; ++i) {
            solids_.push_back(random.polyhedron(4 + i));
            solids_.push_back(grid_hull(random));
            solids_.push_back(regular_prism(3 + i % 9, random.uniform(0.2, 1), random.uniform(0.1, 2)));
            solids_.push_back(make_box(random.vector(0.1, 2)));
            const double thin = std::pow(10, random.uniform(-6, 0));
            solids_.push_back(stretched(random.polyhedron(12), {1, 1, thin}));
            solids_.push_back(stretched(random.polyhedron(12), {thin, 1, thin}));
            solids_.push_back(stretched(cube(1), {1, thin, 1}));
        }
        solids_.push_back(cube(1));
        solids_.push_back(cube(2));
        solids_.push_back(icosahedron(1));
    }

    const ConvexPolyhedron& draw(Random& random) const {
        return solids_[static_cast<std::size_t>(random.uniform() * static_cast<double>(solids_.size()))];
    }

  private:
    // Points on a grid of halves: many parallel faces and faces through one another's vertices.
    static ConvexPolyhedron grid_hull(Random& random) {
        std::vector<Vec3> points;
        for (int axis = 0; axis < 3; ++axis) {
            points.emplace_back(0.5 * Vec3::Unit(axis));
            points.emplace_back(-0.5 * Vec3::Unit(axis));
        }
        for (int i = 0; i < 12; ++i) {
            points.emplace_back((2 * random.vector()).array().round() / 2);
        }
        return convex_hull(points).solid;
    }

    std::vector<ConvexPolyhedron> solids_;
};

/// A pose near the origin: generic, or on a grid with axes along the world's, or a hair off that.
inline Pose nasty_pose(Random& random) {
    if (random.uniform() < 0.4) {
        return {random.vector(), random.rotation()};
    }
    Pose pose{(2 * random.vector()).array().round() / 2, Quat::Identity()};
    for (int axis = 0; axis < 3; ++axis) {
        const double quarters = std::floor(random.uniform(0, 4));
        pose.orientation = turned(quarters * std::atan(1.0) * 2, Vec3::Unit(axis)) * pose.orientation;
    }
    if (random.uniform() < 0.5) {
        const double hair = std::pow(10, random.uniform(-17, -6));
        pose.position += hair * random.vector();
        pose.orientation = rotation(hair * random.vector()) * pose.orientation;
    }
    return pose;
}

}  // namespace scree::test
