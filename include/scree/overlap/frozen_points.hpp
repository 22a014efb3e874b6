#pragma once

#include <array>
#include <span>

#include <scree/overlap/pair_geometry.hpp>

namespace scree {

/// A point of contact as a narrowphase finds it, kept in the frames of the two shapes.
struct FrozenPoint {
    Vec3 on_a = Vec3::Zero();     ///< [m], in A's frame
    Vec3 on_b = Vec3::Zero();     ///< [m], in B's frame
    Vec3 normal = Vec3::UnitZ();  ///< unit, out of B, in B's frame
};

/// Contact in a few points that stay where they are in the bodies while these move. Each is a point of A
/// against a plane of B, sunk in by δ_i = n_i·(b_i − a_i), and stands for the prism of that depth on an equal
/// share of a given area, whether it is sunk in or not: V = (area/N) Σ δ_i over those with δ_i > 0. With the
/// area Lc² each is a spring of stiffness Y Lc/N.
class FrozenPoints final : public PairGeometry {
  public:
    static constexpr std::size_t most = 16;

    /// `area` [m²] is what the points share.
    explicit FrozenPoints(double area) : area_(area) {}

    /// Replaces the points; throws std::invalid_argument for more than `most`.
    void freeze(std::span<const FrozenPoint> points);
    [[nodiscard]] std::span<const FrozenPoint> points() const { return std::span(points_).first(count_); }

    bool geometry(const Pose& pose_a, const Pose& pose_b, Detail detail, bool was_centre_line,
                  OverlapWorkspace& workspace, ContactGeometry& geometry) const override;

  private:
    std::array<FrozenPoint, most> points_;
    std::size_t count_ = 0;
    double area_;
};

}  // namespace scree
