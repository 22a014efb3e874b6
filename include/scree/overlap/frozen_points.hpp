#pragma once

#include <array>
#include <optional>
#include <span>

#include <scree/mesh/saved_state.hpp>
#include <scree/overlap/pair_geometry.hpp>

namespace scree {

/// A point of contact as a narrowphase finds it, kept in the frames of the two shapes. A surface that is
/// round there is kept by the centre of its curvature, so that it may roll away under the point.
struct FrozenPoint {
    Vec3 on_a = Vec3::Zero();     ///< [m], in A's frame
    Vec3 on_b = Vec3::Zero();     ///< [m], in B's frame
    Vec3 normal = Vec3::UnitZ();  ///< unit, out of B, in B's frame; of a plane of A: in A's
    double radius_a = 0;          ///< [m], how far A's surface is from on_a towards B
    double radius_b = 0;          ///< [m], how far B's surface is from on_b towards A
    double slack = 0;             ///< [m], depth that bears no load
};
void visit_state(auto& with, StateOf<FrozenPoint> auto& point) {
    auto& [on_a, on_b, normal, radius_a, radius_b, slack] = point;
    with(on_a, on_b, normal, radius_a, radius_b, slack);
}

/// Contact in a few points that stay where they are in the bodies while these move. Each is a point of one
/// body against a plane of the other, sunk in by δ_i, the distance of the two along the plane's normal less
/// the slack; or two round surfaces, whose normal is the line between their centres. Each stands for the
/// prism of that depth on an equal share of a given area, whether it is sunk in or not: V = (area/N) Σ δ_i
/// over those with δ_i > 0. With the area Lc² each is a spring of stiffness Y Lc/N.
class FrozenPoints final : public PairGeometry {
  public:
    static constexpr std::size_t most = 16;  ///< how many points there can be
    /// Whose planes the points lie against: those of A, or those of B.
    enum class Planes { of_a, of_b };

    /// Replaces the points, which share the `area` [m²]. Throws std::invalid_argument for more than `most`.
    void freeze(std::span<const FrozenPoint> points, double area, Planes planes = Planes::of_b);
    /// Against planes of A they have A and B exchanged.
    [[nodiscard]] std::span<const FrozenPoint> points() const { return std::span(points_).first(count_); }

    /// How deep [m] a surface point of A and one of B, given where they are on the bodies, are loaded now:
    /// that of the nearest point within `distance` [m] of either; nothing where there is none.
    [[nodiscard]] std::optional<double> load_near(const Vec3& on_a, const Vec3& on_b, const Pose& pose_a,
                                                  const Pose& pose_b, double distance) const;

    bool geometry(const Pose& pose_a, const Pose& pose_b, Detail detail, bool was_centre_line,
                  OverlapWorkspace& workspace, ContactGeometry& geometry) const override;

    friend void visit_state(auto& with, StateOf<FrozenPoints> auto& frozen) {
        auto& [points, count, area, exchanged] = frozen;
        with.up_to(most, count);
        with(area, exchanged);
        for (auto& point : std::span(points).first(count)) {
            with(point);
        }
    }

  private:
    [[nodiscard]] bool on_planes_of_b(const Pose& pose_a, const Pose& pose_b, bool was_centre_line,
                                      ContactGeometry& geometry) const;

    std::array<FrozenPoint, most> points_;  ///< of planes of A: with A and B exchanged
    std::size_t count_ = 0;
    double area_ = 0;
    bool exchanged_ = false;
};

}  // namespace scree
