#include "readers.hpp"
#include "values.hpp"

namespace scree {

namespace {

/// true: limit surface, false, or "patch"; for materials and pairs.
template <class T>
void read_torsion(const Node& node, T& target) {
    target.patch_friction = node.value() == "patch";
    if (!target.patch_friction && !node.value().is_boolean()) {
        node.refuse("true, false or \"patch\"");
    }
    target.torsion = target.patch_friction || node.value().get<bool>();
}

using M = MaterialDescription;
constexpr Field<M> material_fields[] = {
    {"density", into<&M::density, positive>, required},
    {"youngs_modulus", into<&M::youngs_modulus, positive>, required},
    {"friction", into<&M::friction, not_negative>, required},
    {"normal_damping", into<&M::normal_damping, not_negative>},
    {"tangential_damping", into<&M::tangential_damping, not_negative>},
    {"tangential_ratio", into<&M::tangential_ratio, positive>},
    {"torsion", read_torsion},
    {"cohesion", into<&M::cohesion, not_negative>},
    {"rolling_friction", into<&M::rolling_friction, not_negative>},
    {"kinetic_friction", into<&M::kinetic_friction, not_negative>},
};

void read_pair_names(const Node& node, PairDescription& pair) {
    if (!node.value().is_array() || node.value().size() != 2) {
        node.refuse("the names of two materials");
    }
    pair.materials = {name(Node(node, 0)), name(Node(node, 1))};
}

using P = PairDescription;
constexpr Field<P> pair_fields[] = {
    {"materials", read_pair_names, required},
    {"youngs_modulus", into<&P::youngs_modulus, positive>},
    {"friction", into<&P::friction, not_negative>},
    {"normal_damping", into<&P::normal_damping, not_negative>},
    {"tangential_damping", into<&P::tangential_damping, not_negative>},
    {"tangential_ratio", into<&P::tangential_ratio, positive>},
    {"torsion", read_torsion},
    {"cohesion", into<&P::cohesion, not_negative>},
    {"rolling_friction", into<&P::rolling_friction, not_negative>},
    {"kinetic_friction", into<&P::kinetic_friction, not_negative>},
};

}  // namespace

void read_material(const Node& node, MaterialDescription& material) {
    read_fields(node, material_fields, material);
    if (material.kinetic_friction && *material.kinetic_friction > material.friction) {
        Node(node, "kinetic_friction").refuse("at most the friction, " + shown(material.friction));
    }
}

void read_pair(const Node& node, PairDescription& pair) {
    read_fields(node, pair_fields, pair);
}

}  // namespace scree
