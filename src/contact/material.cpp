#include <scree/contact/material.hpp>

#include <algorithm>
#include <cmath>

namespace scree {

PairMaterial mix(const Material& a, const Material& b) {
    PairMaterial pair;
    pair.youngs_modulus = 2 / (1 / a.youngs_modulus + 1 / b.youngs_modulus);
    pair.friction = std::min(a.friction, b.friction);
    pair.normal_damping = 0.5 * (a.normal_damping + b.normal_damping);
    pair.tangential_damping = 0.5 * (a.tangential_damping + b.tangential_damping);
    pair.tangential_ratio = 0.5 * (a.tangential_ratio + b.tangential_ratio);
    pair.torsion = a.torsion && b.torsion;
    pair.patch_friction = a.patch_friction && b.patch_friction;
    pair.rolling_friction = std::min(a.rolling_friction, b.rolling_friction);
    pair.cohesion = std::min(a.cohesion, b.cohesion);
    if (a.kinetic_friction || b.kinetic_friction) {
        pair.kinetic_friction =
            std::min(a.kinetic_friction.value_or(a.friction), b.kinetic_friction.value_or(b.friction));
    }
    return pair;
}

double characteristic_length(const BodySize& a, const BodySize& b) {
    const double radius_a = std::isinf(a.mass) ? b.radius : a.radius;
    const double radius_b = std::isinf(b.mass) ? a.radius : b.radius;
    return 4 * radius_a * radius_b / (radius_a + radius_b);
}

double reduced_mass(const BodySize& a, const BodySize& b) {
    return 1 / (1 / a.mass + 1 / b.mass);
}

double round_mass(const BodySize& a, const BodySize& b) {
    const auto turning = [](const BodySize& body) {
        return std::isinf(body.mass) ? 0 : body.radius * body.radius / body.inertia.mean();
    };
    return 1 / (1 / a.mass + 1 / b.mass + turning(a) + turning(b));
}

PairConstants pair_constants(const PairMaterial& material, const BodySize& a, const BodySize& b) {
    PairConstants pair;
    const double y = material.youngs_modulus;
    const double length = characteristic_length(a, b);
    const double mass = reduced_mass(a, b);
    const double tangential = material.tangential_ratio * y;
    pair.length = length;
    pair.reduced_mass = mass;
    pair.round_mass = round_mass(a, b);
    pair.elastic = y / length;
    pair.normal_damping = material.normal_damping * std::sqrt(y / length * mass) / length;
    pair.tangential_stiffness = tangential * length;
    pair.tangential_damping = material.tangential_damping * std::sqrt(tangential * mass * length);
    pair.friction = material.friction;
    pair.kinetic_friction = std::min(material.kinetic_friction.value_or(pair.friction), pair.friction);
    pair.rolling_friction = material.rolling_friction;
    pair.cohesion = material.cohesion;
    pair.torsion = material.torsion;
    pair.patch_friction = material.patch_friction;
    pair.even_damping = material.even_damping;
    pair.inverse_inertia_a = a.inertia.cwiseInverse();
    pair.inverse_inertia_b = b.inertia.cwiseInverse();
    return pair;
}

}  // namespace scree
