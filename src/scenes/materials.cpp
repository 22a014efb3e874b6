#include "materials.hpp"

#include <algorithm>

#include <scree/world/automatic_material.hpp>

namespace scree {

namespace {

void override_named(const PairDescription& entry, PairMaterial& pair) {
    pair.youngs_modulus = entry.youngs_modulus.value_or(pair.youngs_modulus);
    pair.friction = entry.friction.value_or(pair.friction);
    pair.normal_damping = entry.normal_damping.value_or(pair.normal_damping);
    pair.tangential_damping = entry.tangential_damping.value_or(pair.tangential_damping);
    pair.tangential_ratio = entry.tangential_ratio.value_or(pair.tangential_ratio);
    pair.rolling_friction = entry.rolling_friction.value_or(pair.rolling_friction);
    pair.cohesion = entry.cohesion.value_or(pair.cohesion);
    if (entry.torsion) {
        pair.torsion = *entry.torsion;
        pair.patch_friction = entry.patch_friction;
    }
    if (entry.kinetic_friction) {
        pair.kinetic_friction = entry.kinetic_friction;
    }
}

}  // namespace

PairMaterial pair_material(const SceneDescription& scene, const std::string& a, const std::string& b) {
    PairMaterial pair = mix(scene.materials.at(a), scene.materials.at(b));
    for (const PairDescription& entry : scene.pairs) {
        const auto& [c, d] = entry.materials;
        if ((a == c && b == d) || (a == d && b == c)) {
            override_named(entry, pair);
        }
    }
    return pair;
}

double pair_restitution(const PairMaterial& pair) {
    return restitution(std::min(1.0, pair.normal_damping / normal_damping(1)));
}

}  // namespace scree
