#include "materials.hpp"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <cmath>

#include <scree/world/automatic_material.hpp>

namespace scree {

void Materials::prepare(std::span<const WorldBody> bodies, std::span<const Body> physical, double gravity) {
    known_.clear();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        known_.push_back({of(bodies[b], physical[b], gravity), given_.contains(bodies[b].object)});
    }
}

Material Materials::of(const WorldBody& body, const Body& physical, double gravity) const {
    if (const auto found = given_.find(body.object); found != given_.end()) {
        return found->second;
    }
    const UnnamedBody unnamed{physical.mass, physical.radius, body.object->getFriction(),
                              body.object->getRestitution()};
    return automatic_material(unnamed, body.shape, gravity);
}

PairConstants Materials::constants(std::span<const WorldBody> bodies, std::span<const Body> physical,
                                   std::size_t a, std::size_t b) const {
    return pair_constants(pair(bodies[a], known_[a], bodies[b], known_[b]), body_size(physical[a]),
                          body_size(physical[b]));
}

PairMaterial Materials::pair(const WorldBody& a, const Known& known_a, const WorldBody& b,
                             const Known& known_b) const {
    Material material_a = known_a.material;
    Material material_b = known_b.material;
    if (std::isinf(material_a.youngs_modulus)) {
        material_a.youngs_modulus = material_b.youngs_modulus;
    } else if (std::isinf(material_b.youngs_modulus)) {
        material_b.youngs_modulus = material_a.youngs_modulus;
    }
    if (mixing_ && a.rigid != nullptr && b.rigid != nullptr) {
        return mixing_(*a.rigid, material_a, *b.rigid, material_b);
    }
    PairMaterial pair = mix(material_a, material_b);
    if (!known_a.given && !known_b.given) {
        const double bounce = gCalculateCombinedRestitutionCallback(a.object, b.object);
        pair.friction = std::max(0.0, gCalculateCombinedFrictionCallback(a.object, b.object));
        pair.normal_damping = normal_damping(damping_ratio(bounce));
    }
    return pair;
}

}  // namespace scree
