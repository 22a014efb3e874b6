#pragma once

#include <memory>
#include <span>

#include <scree/detect/overlap_dispatch.hpp>
#include <scree/dynamics/step_problem.hpp>

#include "bodies.hpp"
#include "manifold_contacts.hpp"

namespace scree {

/// Keeps Bullet's manifolds up to date with the contacts, for programs that look at them.
class Manifolds {
  public:
    Manifolds(btDispatcher* dispatcher, const ManifoldContacts& contacts);

    /// Whether Bullet's narrowphase is the overlap, where there is one.
    void use_overlaps(bool used);

    /// Off: nothing is done, and what there was is let go.
    void set_on(bool on, btCollisionWorld& world);
    /// Lets go of all algorithms.
    static void clear(btCollisionWorld& world);

    /// Runs Bullet's narrowphase, which for most shapes is the overlap, over the pairs of its broadphase but
    /// for those whose contacts have a manifold already, and notes in the points the impulses of the contacts
    /// over a tick [s] of the present forces.
    void update(btCollisionWorld& world, const Bodies& bodies, const System& system,
                std::span<const ContactResult> results, double tick);

    /// Pairs that were handed to the narrowphase so far.
    [[nodiscard]] std::size_t pairs() const { return pairs_; }

  private:
    [[nodiscard]] bool has_manifold(const Bodies& bodies, const btBroadphasePair& pair) const;
    btPersistentManifold* manifold_of(btCollisionWorld& world, const Contact& contact, const Bodies& bodies,
                                      const Vec3& point);

    btCollisionDispatcher* dispatcher_;  ///< null: one that is not of Bullet's class
    const ManifoldContacts& contacts_;
    std::shared_ptr<OverlapDispatch> overlaps_;
    bool on_ = true;
    std::size_t pairs_ = 0;
    btManifoldArray found_;
};

/// Lets go of the algorithms of an object whose shape has been replaced.
void forget_algorithms(btCollisionWorld& world, btCollisionObject& object);

}  // namespace scree
