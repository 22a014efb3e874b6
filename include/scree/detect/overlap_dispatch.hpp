#pragma once

#include <btBulletCollisionCommon.h>

#include <memory>
#include <vector>

#include <scree/detect/body_shape.hpp>
#include <scree/overlap/overlap.hpp>

namespace scree {

/// The overlap of exact shapes in the place of a dispatcher's own algorithms, for all pairs of shapes that
/// have one: so contact tests, callbacks and manifolds speak of the same contacts as the forces. A manifold
/// gets the corners of the patch, at most four.
///
/// Worlds that share a dispatcher share one of these; the last one to let it go gives the dispatcher its own
/// algorithms back. Nothing here is shared between dispatchers.
class OverlapDispatch : public std::enable_shared_from_this<OverlapDispatch> {
    struct Private {};

  public:
    /// The dispatcher's own; made, and put in place, when there is none yet.
    static std::shared_ptr<OverlapDispatch> of(btCollisionDispatcher& dispatcher);

    /// Puts the overlap in place in the dispatcher's tables.
    OverlapDispatch(Private /*only of() makes one*/, btCollisionDispatcher& dispatcher);
    ~OverlapDispatch();
    OverlapDispatch(const OverlapDispatch&) = delete;
    OverlapDispatch& operator=(const OverlapDispatch&) = delete;

    /// What the dispatcher had for a pair of shape types before.
    [[nodiscard]] btCollisionAlgorithmCreateFunc& stock(int type_a, int type_b) const;

    /// What the algorithms share; one thread at a time uses a dispatcher.
    struct Tools {
        ShapeLibrary library;        ///< of the exact shapes
        OverlapWorkspace workspace;  ///< of the overlap computation
        ContactGeometry geometry;    ///< of the pair at hand
    };
    /// Kept alive by every algorithm that uses them.
    [[nodiscard]] const std::shared_ptr<Tools>& tools() const { return tools_; }

  private:
    class Creator;
    struct Place;

    void put(Place place, int type_a, int type_b);

    btCollisionDispatcher& dispatcher_;
    std::shared_ptr<Tools> tools_ = std::make_shared<Tools>();
    std::vector<std::unique_ptr<Creator>> creators_;
};

}  // namespace scree
