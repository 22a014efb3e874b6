#pragma once

#include <btBulletCollisionCommon.h>

#include <limits>

#include <scree/detect/body_shape.hpp>
#include <scree/overlap/frozen_points.hpp>

namespace scree {

/// Contact where Bullet's own narrowphase finds it: the points of its manifold, at most four for two convex
/// shapes, frozen in the bodies from one update to the next. The manifold persists and gathers points as
/// Bullet's does, for GJK gives one a call; while it has none, the nearest points of the two surfaces stand
/// ready, so that nothing passes between two updates. Margins count as Bullet counts them.
class ManifoldGeometry final : public PairGeometry {
  public:
    /// A part of a body, as Bullet has it.
    struct Side {
        btCollisionObject* object = nullptr;  ///< in Bullet's world
        BodyPart part;                        ///< of that object
        int index = 0;                        ///< of the part, for Bullet's users
    };

    /// Of two parts; without points before the first update. The dispatcher must outlive it.
    ManifoldGeometry(btDispatcher& dispatcher, Side a, Side b);
    ~ManifoldGeometry() override;

    /// Where the two are, and how near their surfaces must be to count as near.
    struct Situation {
        Pose body_a,       ///< of the first body's frame
            body_b;        ///< of the second one's
        double reach = 0;  ///< [m]
        double area = 0;   ///< [m²], that the points share
        /// [m], by which the load of a point that is found deep may grow in one update, beside a tenth.
        double growth = std::numeric_limits<double>::infinity();
    };
    /// Runs the narrowphase with the objects there for the time being, and freezes what it finds.
    void update(const Situation& now, const btDispatcherInfo& info);

    /// What is carried from one update to the next: the manifold's points and what was frozen.
    void save(StateWriter& with);
    /// With the objects where they were at the last update, or later.
    void restore(StateReader& with, const Situation& now, const btDispatcherInfo& info);

    /// Lets go of everything in Bullet, before one of the objects goes. The points stay as they are.
    void release();
    /// Whether one of the two is this object.
    [[nodiscard]] bool concerns(const btCollisionObject& object) const {
        return a_.object == &object || b_.object == &object;
    }
    /// What the last update froze.
    [[nodiscard]] const FrozenPoints& frozen() const { return points_; }
    /// The manifold with the points, null when there is none.
    [[nodiscard]] btPersistentManifold* manifold();

    bool geometry(const Pose& pose_a, const Pose& pose_b, Detail detail, bool was_centre_line,
                  OverlapWorkspace& workspace, ContactGeometry& geometry) const override {
        return points_.geometry(pose_a, pose_b, detail, was_centre_line, workspace, geometry);
    }

  private:
    /// Runs Bullet's algorithm, which adds to the manifold.
    void gather(const Situation& now, const btDispatcherInfo& info);

    btDispatcher& dispatcher_;
    Side a_, b_;
    btCollisionAlgorithm* algorithm_ = nullptr;
    btManifoldArray found_;
    FrozenPoints points_;
};

}  // namespace scree
