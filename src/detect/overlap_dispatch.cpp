#include <scree/detect/overlap_dispatch.hpp>

#include <array>

#include "overlap_algorithm.hpp"

namespace scree {

namespace {

// All shapes that the library translates, but for compounds, whose children come one by one.
constexpr std::array overlapping_types{
    static_cast<int>(BOX_SHAPE_PROXYTYPE),    static_cast<int>(CONVEX_HULL_SHAPE_PROXYTYPE),
    static_cast<int>(SPHERE_SHAPE_PROXYTYPE), static_cast<int>(CAPSULE_SHAPE_PROXYTYPE),
    static_cast<int>(CONE_SHAPE_PROXYTYPE),   static_cast<int>(CYLINDER_SHAPE_PROXYTYPE),
    static_cast<int>(STATIC_PLANE_PROXYTYPE)};

using Table =
    btCollisionAlgorithmCreateFunc* [MAX_BROADPHASE_COLLISION_TYPES][MAX_BROADPHASE_COLLISION_TYPES];

/// The tables in which a dispatcher looks an algorithm up.
struct DispatchTables : btCollisionDispatcher {
    static Table& contact(btCollisionDispatcher& dispatcher) {
        return dispatcher.*(&DispatchTables::m_doubleDispatchContactPoints);
    }
    static Table& closest(btCollisionDispatcher& dispatcher) {
        return dispatcher.*(&DispatchTables::m_doubleDispatchClosestPoints);
    }
};

std::size_t at(int type) {
    return static_cast<std::size_t>(type);
}

}  // namespace

struct OverlapDispatch::Place {
    Table& (*table)(btCollisionDispatcher&);
};

class OverlapDispatch::Creator : public btCollisionAlgorithmCreateFunc {
  public:
    Creator(OverlapDispatch& owner, Place place, int type_a, int type_b)
        : owner_(owner),
          tools_(owner.tools_),
          place_(place),
          type_a_(type_a),
          type_b_(type_b),
          stock_(*slot()) {
        slot() = this;
    }
    ~Creator() override {
        if (slot() == this) {
            slot() = &stock_;
        }
    }
    Creator(const Creator&) = delete;
    Creator& operator=(const Creator&) = delete;

    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* /*a*/,
                                                   const btCollisionObjectWrapper* /*b*/) override {
        void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(OverlapAlgorithm));
        return new (memory) OverlapAlgorithm(info, tools_, stock_);
    }
    [[nodiscard]] OverlapDispatch& owner() const { return owner_; }
    [[nodiscard]] btCollisionAlgorithmCreateFunc& stock() const { return stock_; }

  private:
    [[nodiscard]] btCollisionAlgorithmCreateFunc*& slot() const {
        return place_.table(owner_.dispatcher_)[at(type_a_)][at(type_b_)];
    }

    OverlapDispatch& owner_;
    std::shared_ptr<Tools> tools_;
    Place place_;
    int type_a_, type_b_;
    btCollisionAlgorithmCreateFunc& stock_;
};

std::shared_ptr<OverlapDispatch> OverlapDispatch::of(btCollisionDispatcher& dispatcher) {
    for (const int type_a : overlapping_types) {
        for (const int type_b : overlapping_types) {
            auto* known = DispatchTables::contact(dispatcher)[at(type_a)][at(type_b)];
            if (auto* creator = dynamic_cast<Creator*>(known)) {
                return creator->owner().shared_from_this();
            }
        }
    }
    return std::make_shared<OverlapDispatch>(Private(), dispatcher);
}

OverlapDispatch::OverlapDispatch(Private /*only of() makes one*/, btCollisionDispatcher& dispatcher)
    : dispatcher_(dispatcher) {
    for (const int type_a : overlapping_types) {
        for (const int type_b : overlapping_types) {
            if (type_a != STATIC_PLANE_PROXYTYPE || type_b != STATIC_PLANE_PROXYTYPE) {
                put({&DispatchTables::contact}, type_a, type_b);
                put({&DispatchTables::closest}, type_a, type_b);
            }
        }
    }
}

OverlapDispatch::~OverlapDispatch() = default;

void OverlapDispatch::put(Place place, int type_a, int type_b) {
    creators_.push_back(std::make_unique<Creator>(*this, place, type_a, type_b));
}

btCollisionAlgorithmCreateFunc& OverlapDispatch::stock(int type_a, int type_b) const {
    auto* known = DispatchTables::contact(dispatcher_)[at(type_a)][at(type_b)];
    const auto* creator = dynamic_cast<const Creator*>(known);
    return creator != nullptr ? creator->stock() : *known;
}

}  // namespace scree
