#pragma once

#include <memory>
#include <span>

#include <scree/detect/overlap_dispatch.hpp>
#include <scree/dynamics/step_problem.hpp>

#include "bodies.hpp"

namespace scree {

/// Keeps Bullet's manifolds up to date with the contacts, for programs that look at them.
class Manifolds {
  public:
    explicit Manifolds(btDispatcher* dispatcher);

    /// Off: nothing is done, and what there was is let go.
    void set_on(bool on, btCollisionWorld& world);

    /// Runs Bullet's narrowphase, which for most shapes is the overlap, over the pairs of its broadphase, and
    /// notes in the points the impulses of the contacts over a tick [s] of the present forces.
    void update(btCollisionWorld& world, std::span<const WorldBody> bodies, const System& system,
                std::span<const ContactResult> results, double tick);

    /// Pairs that were handed to the narrowphase so far.
    [[nodiscard]] std::size_t pairs() const { return pairs_; }

  private:
    void note_impulses(btCollisionWorld& world, const WorldBody& a, const WorldBody& b,
                       const ContactResult& result, double tick);

    btCollisionDispatcher* dispatcher_;  ///< null: one that is not of Bullet's class
    std::shared_ptr<OverlapDispatch> overlaps_;
    bool on_ = true;
    std::size_t pairs_ = 0;
    btManifoldArray found_;
};

/// Lets go of the algorithms of an object whose shape has been replaced.
void forget_algorithms(btCollisionWorld& world, btCollisionObject& object);

}  // namespace scree
