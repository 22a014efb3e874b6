#pragma once

#include <scree/detect/overlap_dispatch.hpp>

namespace scree {

/// Finds the contact points of two shapes by their overlap. For shapes that have none, as a hull without
/// volume, and for the distance of shapes that are apart, it asks Bullet's own algorithm.
class OverlapAlgorithm : public btCollisionAlgorithm {
  public:
    OverlapAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                     std::shared_ptr<OverlapDispatch::Tools> tools, btCollisionAlgorithmCreateFunc& stock);
    ~OverlapAlgorithm() override;
    OverlapAlgorithm(const OverlapAlgorithm&) = delete;
    OverlapAlgorithm& operator=(const OverlapAlgorithm&) = delete;

    void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                          const btDispatcherInfo& info, btManifoldResult* result) override;
    btScalar calculateTimeOfImpact(btCollisionObject* a, btCollisionObject* b, const btDispatcherInfo& info,
                                   btManifoldResult* result) override;
    void getAllContactManifolds(btManifoldArray& manifolds) override;

  private:
    struct State;
    /// Bullet's pool of algorithms has room for its own ones only.
    std::unique_ptr<State> state_;
};

}  // namespace scree
