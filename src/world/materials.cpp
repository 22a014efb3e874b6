#include "materials.hpp"

#include <cmath>

#include <scree/world/automatic_material.hpp>

namespace scree {

void Materials::prepare(std::span<const WorldBody> bodies, std::span<const Body> physical, double gravity) {
    known_.clear();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].object == nullptr) {
            known_.emplace_back();  // removed, and about to go
            continue;
        }
        known_.push_back({of(bodies[b], physical[b], gravity), given_.contains(bodies[b].object)});
    }
}

Material Materials::of(const WorldBody& body, const Body& physical, double gravity) const {
    if (const auto found = given_.find(body.object); found != given_.end()) {
        return found->second;
    }
    return automatic_material({physical.mass, physical.radius, surface_properties(*body.object)}, body.shape,
                              gravity);
}

void Materials::set_law(const Material& a, const Material& b, int law) {
    laws_.push_back({a, b, law});
}

int Materials::law_of(const Material& a, const Material& b) const {
    for (auto entry = laws_.rbegin(); entry != laws_.rend(); ++entry) {
        if ((entry->a == a && entry->b == b) || (entry->a == b && entry->b == a)) {
            return entry->law;
        }
    }
    return 0;
}

PairConstants Materials::constants(std::span<const WorldBody> bodies, std::span<const Body> physical,
                                   std::size_t a, std::size_t b) const {
    PairConstants constants =
        pair_constants(pair(bodies, physical, a, b), body_size(physical[a]), body_size(physical[b]));
    constants.law = law_of(known_[a].material, known_[b].material);
    return constants;
}

PairMaterial Materials::pair(std::span<const WorldBody> bodies, std::span<const Body> physical, std::size_t a,
                             std::size_t b) const {
    Material material_a = known_[a].material;
    Material material_b = known_[b].material;
    if (std::isinf(material_a.youngs_modulus)) {
        material_a.youngs_modulus = material_b.youngs_modulus;
    } else if (std::isinf(material_b.youngs_modulus)) {
        material_b.youngs_modulus = material_a.youngs_modulus;
    }
    if (mixing_ && bodies[a].rigid != nullptr && bodies[b].rigid != nullptr) {
        return mixing_(*bodies[a].rigid, material_a, *bodies[b].rigid, material_b);
    }
    const PairMaterial mixed = mix(material_a, material_b);
    if (known_[a].given || known_[b].given) {
        return mixed;
    }
    return combined_by_bullet(mixed, *bodies[a].object, body_size(physical[a]), *bodies[b].object,
                              body_size(physical[b]));
}

}  // namespace scree
