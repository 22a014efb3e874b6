#pragma once

#include <btBulletDynamicsCommon.h>

#include <functional>

namespace scree {

/// Bullet's own solver, which takes friction and restitution of each pair as they are given, instead of
/// products of numbers of the two bodies.
class PairSolver final : public btSequentialImpulseConstraintSolver {
  public:
    /// Called with each manifold before it is solved.
    using Adjust = std::function<void(btPersistentManifold&)>;
    explicit PairSolver(Adjust adjust) : adjust_(std::move(adjust)) {}

  protected:
    void convertContacts(btPersistentManifold** manifolds, int count,
                         const btContactSolverInfo& info) override {
        for (int i = 0; i < count; ++i) {
            adjust_(*manifolds[i]);
        }
        btSequentialImpulseConstraintSolver::convertContacts(manifolds, count, info);
    }

  private:
    Adjust adjust_;
};

/// Makes a contact point drive along what lies on a conveyor. `surface` is the velocity of A's surface less
/// that of B's [m/s]; its part across the contact counts for nothing.
void drive(const btVector3& surface, const btVector3& relative_velocity, btManifoldPoint& point);

}  // namespace scree
