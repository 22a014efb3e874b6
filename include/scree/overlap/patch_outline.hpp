#pragma once

#include <vector>

#include <scree/overlap/clip.hpp>

namespace scree {

/// A convex solid as it is seen along a direction: its outline, and how deep it is behind each point of that.
class PatchOutline {
  public:
    /// Of a solid, along `normal` from a point `centre` inside it, in axes `axis` and normal × axis; all in
    /// the solid's frame.
    void see(const ClippedSolid& solid, const Vec3& centre, const Vec3& axis, const Vec3& normal);

    /// Whether the outline goes once round the centre.
    [[nodiscard]] bool surrounds_origin() const;
    /// How far [m] the outline is from the centre in a unit direction.
    [[nodiscard]] double reach(const Vec2& direction) const;
    /// [m], of the solid along the normal.
    [[nodiscard]] double depth(const Vec2& at) const;
    /// ∫ ‖x‖ depth dA / ∫ depth dA [m]: the mean distance from the centre of what presses by depth.
    [[nodiscard]] double loaded_lever() const { return moment_ / volume_; }

  private:
    /// A face as a height over the plane of view.
    struct Sheet {
        double height = 0;  ///< [m], at the centre
        Vec2 slope = Vec2::Zero();
    };

    void find_hull();
    void add_face(const ClippedSolid& solid, const ClippedSolid::Face& face);

    Vec3 centre_, normal_;
    Eigen::Matrix<double, 2, 3> view_;
    std::vector<Vec2> corners_, hull_;  ///< of the vertices as seen; those of the outline, counter-clockwise
    std::vector<Sheet> top_, bottom_;
    double volume_ = 0;  ///< [m³]
    double moment_ = 0;  ///< ∫ ‖x‖ depth dA [m⁴]
};

}  // namespace scree
