#pragma once

#include <array>
#include <span>

#include <scree/overlap/overlap.hpp>

namespace scree {

/// One of a few points that stand for an overlap.
struct ContactPoint {
    Vec3 on_a = Vec3::Zero();  ///< [m], on A's surface, world frame
    Vec3 on_b = Vec3::Zero();  ///< [m], on B's surface, on_a + depth n
    double depth = 0;          ///< [m] > 0, the overlap's extent along n there
};

/// At most four points of an overlap, the deepest first, then those that spread widest across the normal: the
/// corners of a patch that are at least a tenth as deep as the deepest, no two of them nearer to each other
/// than `spacing` [m]. One for a smooth contact. The overlap is the last one that the workspace was used for,
/// between these shapes at these poses.
class ContactPoints {
  public:
    static constexpr std::size_t most = 4;  ///< as many as a manifold of Bullet's has

    /// Chooses the points; a shape's pose places its frame in the world.
    ContactPoints(const Shape& a, const Pose& pose_a, const ContactGeometry& geometry,
                  OverlapWorkspace& workspace, double spacing);

    /// The points, the deepest first.
    [[nodiscard]] std::span<const ContactPoint> points() const { return std::span(points_).first(count_); }

  private:
    void add_smooth(const Shape& a, const Pose& pose_a, const ContactGeometry& geometry);
    void add_corners(const Pose& pose_a, const ContactGeometry& geometry, OverlapWorkspace& workspace,
                     double spacing);

    std::array<ContactPoint, most> points_;
    std::size_t count_ = 0;
};

}  // namespace scree
