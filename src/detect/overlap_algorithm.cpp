#include "overlap_algorithm.hpp"

#include <stdexcept>
#include <utility>

#include <scree/detect/convert.hpp>
#include <scree/overlap/contact_points.hpp>

#include "manifold_writer.hpp"

namespace scree {

namespace {

/// A shape as it was translated last.
struct Translated {
    const btCollisionShape* bullet = nullptr;
    btVector3 scaling;
    BodyPart part;  // without a shape: it has no overlap

    void follow(const btCollisionShape& shape, ShapeLibrary& library) {
        if (bullet == &shape && scaling == shape.getLocalScaling()) {
            return;
        }
        bullet = &shape;
        scaling = shape.getLocalScaling();
        try {
            part = library.translate(shape).parts.front();
        } catch (const std::invalid_argument&) {
            part = {};
        }
    }
};

bool stands(const btCollisionObjectWrapper& wrap) {
    return wrap.getCollisionObject()->isStaticOrKinematicObject() ||
           wrap.getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE;
}

}  // namespace

struct OverlapAlgorithm::State {
    std::shared_ptr<OverlapDispatch::Tools> tools;
    btCollisionAlgorithmCreateFunc& stock_creator;
    btCollisionAlgorithm* stock = nullptr;
    btPersistentManifold* manifold = nullptr;
    bool owns_manifold = false;
    Translated a, b;

    bool overlapping(const btCollisionObjectWrapper& wrap_a, const btCollisionObjectWrapper& wrap_b);
    void write(const btCollisionObjectWrapper& wrap_a, btManifoldResult& result);
    void ask_stock(btDispatcher& dispatcher, const btCollisionObjectWrapper* wrap_a,
                   const btCollisionObjectWrapper* wrap_b, const btDispatcherInfo& info,
                   btManifoldResult* result);
};

bool OverlapAlgorithm::State::overlapping(const btCollisionObjectWrapper& wrap_a,
                                          const btCollisionObjectWrapper& wrap_b) {
    return overlap(*a.part.shape, to_eigen(wrap_a.getWorldTransform()) * a.part.local, *b.part.shape,
                   to_eigen(wrap_b.getWorldTransform()) * b.part.local, Detail::force, false,
                   tools->workspace, tools->geometry);
}

void OverlapAlgorithm::State::write(const btCollisionObjectWrapper& wrap_a, btManifoldResult& result) {
    const ContactPoints points(*a.part.shape, to_eigen(wrap_a.getWorldTransform()) * a.part.local,
                               tools->geometry, tools->workspace, manifold->getContactBreakingThreshold());
    write_points(points.points(), to_bullet(tools->geometry.normal), *manifold, result);
}

void OverlapAlgorithm::State::ask_stock(btDispatcher& dispatcher, const btCollisionObjectWrapper* wrap_a,
                                        const btCollisionObjectWrapper* wrap_b, const btDispatcherInfo& info,
                                        btManifoldResult* result) {
    if (stock == nullptr) {
        btCollisionAlgorithmConstructionInfo construction(&dispatcher, 0);
        construction.m_manifold = owns_manifold ? nullptr : manifold;
        stock = stock_creator.CreateCollisionAlgorithm(construction, wrap_a, wrap_b);
    }
    stock->processCollision(wrap_a, wrap_b, info, result);
}

OverlapAlgorithm::OverlapAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                   std::shared_ptr<OverlapDispatch::Tools> tools,
                                   btCollisionAlgorithmCreateFunc& stock)
    : btCollisionAlgorithm(info),
      state_(new State{std::move(tools), stock, nullptr, info.m_manifold, false, {}, {}}) {}

OverlapAlgorithm::~OverlapAlgorithm() {
    if (state_->stock != nullptr) {
        state_->stock->~btCollisionAlgorithm();
        m_dispatcher->freeCollisionAlgorithm(state_->stock);
    }
    if (state_->owns_manifold) {
        m_dispatcher->releaseManifold(state_->manifold);
    }
}

void OverlapAlgorithm::processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                        const btDispatcherInfo& info, btManifoldResult* result) {
    State& state = *state_;
    // Bullet compares points by where they are on the first body: that is to be the one that moves.
    if (stands(*a) && !stands(*b)) {
        std::swap(a, b);
    }
    state.a.follow(*a->getCollisionShape(), state.tools->library);
    state.b.follow(*b->getCollisionShape(), state.tools->library);
    if (!state.a.part.shape || !state.b.part.shape) {
        state.ask_stock(*m_dispatcher, a, b, info, result);
        return;
    }
    if (state.overlapping(*a, *b)) {
        if (state.manifold == nullptr) {
            state.manifold = m_dispatcher->getNewManifold(a->getCollisionObject(), b->getCollisionObject());
            state.owns_manifold = true;
        }
        result->setPersistentManifold(state.manifold);
        state.write(*a, *result);
    } else if (result->m_closestPointDistanceThreshold > 0) {
        state.ask_stock(*m_dispatcher, a, b, info, result);
    } else if (state.owns_manifold) {
        result->setPersistentManifold(state.manifold);
        state.manifold->clearManifold();
    }
}

btScalar OverlapAlgorithm::calculateTimeOfImpact(btCollisionObject* /*a*/, btCollisionObject* /*b*/,
                                                 const btDispatcherInfo& /*info*/,
                                                 btManifoldResult* /*result*/) {
    return 1;
}

void OverlapAlgorithm::getAllContactManifolds(btManifoldArray& manifolds) {
    if (state_->owns_manifold) {
        manifolds.push_back(state_->manifold);
    }
    if (state_->stock != nullptr) {
        state_->stock->getAllContactManifolds(manifolds);
    }
}

}  // namespace scree
