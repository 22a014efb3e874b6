#include <scree/detect/pair_search.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <scree/detect/convert.hpp>
#include <scree/overlap/separation.hpp>

namespace scree {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double fatness = 0.05;  // of a body's radius, by which Bullet's tree may enlarge its box

// Bullet's tree enlarges a box that has left its old one by a global length, which suits bodies of a metre;
// here it is handed the larger box, `margin` [m] around, at once.
void put_in_tree(btDbvtBroadphase& tree, btBroadphaseProxy& proxy, const btVector3& low,
                 const btVector3& high, double margin, btDispatcher* dispatcher) {
    if (static_cast<btDbvtProxy&>(proxy).leaf->volume.Contain(btDbvtVolume::FromMM(low, high))) {
        tree.setAabb(&proxy, low, high, dispatcher);
        return;
    }
    const btVector3 around(margin, margin, margin);
    tree.setAabbForceUpdate(&proxy, low - around, high + around, dispatcher);
    proxy.m_aabbMin = low;
    proxy.m_aabbMax = high;
}

// Bullet's filter, but for that it leaves out pairs that both rest: their contacts live on here.
bool want_contact(btDispatcher& dispatcher, const btCollisionObject& a, const btCollisionObject& b) {
    const int state = a.getActivationState();
    const bool resting = !a.isActive() && !b.isActive();
    if (resting) {
        a.forceActivationState(ACTIVE_TAG);
    }
    const bool wanted = dispatcher.needsCollision(&a, &b) && dispatcher.needsResponse(&a, &b);
    if (resting) {
        a.forceActivationState(state);
    }
    return wanted;
}

bool apart(const Bounds& a, const Bounds& b, double reach) {
    return (a.low - b.high).maxCoeff() > reach || (b.low - a.high).maxCoeff() > reach;
}

bool same(const btVector3& a, const btVector3& b) {
    return to_eigen(a) == to_eigen(b);
}

// Bullet's trees take no infinities.
btVector3 finite(const Vec3& corner) {
    return to_bullet(corner.cwiseMax(-BT_LARGE_FLOAT).cwiseMin(BT_LARGE_FLOAT));
}

}  // namespace

const std::vector<PartPair>& PairSearch::find(btCollisionWorld& world, std::span<const SearchBody> bodies) {
    place(world, bodies);
    world.computeOverlappingPairs();
    number_objects(world, bodies);
    pairs_.clear();
    const btBroadphasePairArray& found = world.getPairCache()->getOverlappingPairArray();
    for (int i = 0; i < found.size(); ++i) {
        const int one = number_of(*found[i].m_pProxy0);
        const int other = number_of(*found[i].m_pProxy1);
        if (one >= 0 && other >= 0) {
            add_pairs(std::min(one, other), std::max(one, other), *world.getDispatcher(), bodies);
        }
    }
    std::sort(pairs_.begin(), pairs_.end());
    return pairs_;
}

void PairSearch::place(btCollisionWorld& world, std::span<const SearchBody> bodies) {
    btBroadphaseInterface& broadphase = *world.getBroadphase();
    auto* const tree = dynamic_cast<btDbvtBroadphase*>(&broadphase);
    parts_.clear();
    first_part_.clear();
    for (const SearchBody& body : bodies) {
        const Bounds box = place_parts(body);
        const double around = body.reach + body.skin;
        const btVector3 low = finite(box.low.array() - around);
        const btVector3 high = finite(box.high.array() + around);
        btBroadphaseProxy& proxy = *body.object->getBroadphaseHandle();
        if (same(low, proxy.m_aabbMin) && same(high, proxy.m_aabbMax)) {
            continue;
        }
        if (tree != nullptr) {
            const double radius = body.shape->radius;
            put_in_tree(*tree, proxy, low, high, std::isfinite(radius) ? fatness * radius : 0,
                        world.getDispatcher());
        } else {
            broadphase.setAabb(&proxy, low, high, world.getDispatcher());
        }
    }
}

Bounds PairSearch::place_parts(const SearchBody& body) {
    first_part_.push_back(parts_.size());
    Bounds all{Vec3::Constant(infinity), Vec3::Constant(-infinity)};
    for (const BodyPart& part : body.shape->parts) {
        const Pose pose = body.pose * part.local;
        const Bounds box = bounds(*part.shape, pose);
        parts_.push_back({part.shape.get(), pose, box, bounding_radius(*part.shape)});
        all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
    }
    return all;
}

void PairSearch::number_objects(const btCollisionWorld& world, std::span<const SearchBody> bodies) {
    numbers_.assign(static_cast<std::size_t>(world.getNumCollisionObjects()), -1);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        numbers_[static_cast<std::size_t>(bodies[b].object->getWorldArrayIndex())] = static_cast<int>(b);
    }
}

int PairSearch::number_of(const btBroadphaseProxy& proxy) const {
    const auto* object = static_cast<const btCollisionObject*>(proxy.m_clientObject);
    return numbers_[static_cast<std::size_t>(object->getWorldArrayIndex())];
}

void PairSearch::add_pairs(int a, int b, btDispatcher& dispatcher, std::span<const SearchBody> bodies) {
    const SearchBody& body_a = bodies[static_cast<std::size_t>(a)];
    const SearchBody& body_b = bodies[static_cast<std::size_t>(b)];
    if (!body_a.dynamic && !body_b.dynamic) {
        return;
    }
    const double reach = body_a.reach + body_a.skin + body_b.reach + body_b.skin;
    const PlacedPart* parts_a = &parts_[first_part_[static_cast<std::size_t>(a)]];
    const PlacedPart* parts_b = &parts_[first_part_[static_cast<std::size_t>(b)]];
    bool wanted = false;  // asked once a pair of bodies, and only of those that are near
    for (std::size_t i = 0; i < body_a.shape->parts.size(); ++i) {
        for (std::size_t j = 0; j < body_b.shape->parts.size(); ++j) {
            if (!near(parts_a[i], parts_b[j], reach)) {
                continue;
            }
            wanted = wanted || want_contact(dispatcher, *body_a.object, *body_b.object);
            if (!wanted) {
                return;
            }
            pairs_.push_back({a, b, static_cast<int>(i), static_cast<int>(j)});
        }
    }
}

bool PairSearch::near(const PlacedPart& a, const PlacedPart& b, double reach) {
    if (apart(a.box, b.box, reach)) {
        return false;
    }
    if (const auto* ground = std::get_if<HalfSpace>(a.shape)) {
        return height_above(*ground, a, b) <= reach;
    }
    if (const auto* ground = std::get_if<HalfSpace>(b.shape)) {
        return height_above(*ground, b, a) <= reach;
    }
    const double sum = a.radius + b.radius + reach;
    return (a.pose.position - b.pose.position).squaredNorm() <= sum * sum &&
           separation(*a.shape, a.pose, *b.shape, b.pose).gap <= reach;
}

// Of the part's lowest point [m].
double PairSearch::height_above(const HalfSpace& ground, const PlacedPart& at, const PlacedPart& part) {
    if (std::holds_alternative<HalfSpace>(*part.shape)) {
        return infinity;  // two half-spaces make no contact
    }
    const Vec3 normal = at.pose.orientation * ground.normal;
    const double origin = normal.dot(part.pose.position - at.pose.position) - ground.offset;
    return origin - reach_along(*part.shape, part.pose.orientation.conjugate() * -normal);
}

}  // namespace scree
