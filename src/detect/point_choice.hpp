#pragma once

#include <optional>
#include <vector>

#include <scree/overlap/frozen_points.hpp>

#include "bullet_pair.hpp"

namespace scree {

/// The points of a pair on their way to be frozen: of all that are offered as many as a manifold has.
class PointChoice {
  public:
    /// `before`: what was frozen last.
    PointChoice(const ManifoldGeometry::Side& a, const ManifoldGeometry::Side& b,
                const ManifoldGeometry::Situation& now, const FrozenPoints& before);

    void offer(const std::vector<SurfacePoint>& points);

    /// The outermost of the deepest, then those that are widest of all that are there. None twice: a ball
    /// that has rolled on has its old points too. Those that were there before come first, those that are far
    /// from touching last.
    std::vector<FrozenPoint> choose();
    [[nodiscard]] FrozenPoints::Planes planes() const { return planes_; }

  private:
    struct Offer {
        FrozenPoint point;
        Vec3 where;                  ///< on the body whose points touch planes of the other, world frame [m]
        Vec3 normal;                 ///< world axes
        double depth;                ///< [m], negative: apart
        std::optional<double> load;  ///< that it had, if it was there before [m]
    };

    [[nodiscard]] Offer made_of(const SurfacePoint& point) const;
    [[nodiscard]] double slack(const Offer& offer) const;
    [[nodiscard]] double merit(const Offer& offer, const Vec3& middle) const;
    static double across(const Offer& offer, const Vec3& from);
    [[nodiscard]] double width_beside_taken(const Offer& offer) const;
    [[nodiscard]] bool is_deepest(const Offer& offer) const;
    [[nodiscard]] Vec3 middle_of_deepest() const;

    const Shape& shape_a_;
    const Shape& shape_b_;
    Pose pose_a_, pose_b_;
    FrozenPoints::Planes planes_;
    double skin_a_, skin_b_;  ///< of the body whose points touch planes of the other [m], else none
    double spacing_;          ///< [m]
    double growth_;           ///< of a load [m]
    const FrozenPoints& before_;
    std::vector<Offer> offers_, taken_;
};

}  // namespace scree
