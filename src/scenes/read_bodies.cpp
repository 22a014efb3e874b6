#include "readers.hpp"
#include "values.hpp"

namespace scree {

namespace {

using V = PrescribedMotion;
constexpr Field<V> motion_fields[] = {
    {"velocity", into<&V::velocity, vector>},
    {"angular_velocity", into<&V::angular_velocity, vector>},
    {"about", into<&V::about, vector>},
    {"amplitude", into<&V::amplitude, not_negative>},
    {"frequency", into<&V::frequency, not_negative>},
    {"surface_velocity", into<&V::surface_velocity, vector>},
};

void read_motion(const Node& node, BodyDescription& body) {
    if (node.value().is_object()) {
        read_fields(node, motion_fields, body.motion.emplace<PrescribedMotion>());
    } else if (node.value() == "fixed") {
        body.motion = FixedMotion{};
    } else if (node.value() != "dynamic") {
        node.refuse("\"dynamic\", \"fixed\" or an object");
    }
}

using B = BodyDescription;
constexpr Field<B> body_fields[] = {
    {"name", into<&B::name, name>},
    {"shape", into<&B::shape, name>, required},
    {"material", into<&B::material, name>, required},
    {"motion", read_motion},
    {"position", into<&B::position, vector>},
    {"orientation", into<&B::orientation, orientation>},
    {"velocity", into<&B::velocity, vector>},
    {"angular_velocity", into<&B::angular_velocity, vector>},
};

void read_corners(const Node& node, FillDescription& fill) {
    if (!node.value().is_array() || node.value().size() != 2) {
        node.refuse("the lowest and the highest corner");
    }
    fill.low = vector(Node(node, 0));
    fill.high = vector(Node(node, 1));
    if (!(fill.low.array() < fill.high.array()).all()) {
        node.refuse("the lowest corner, then the highest");
    }
}

using F = FillDescription;
constexpr Field<F> fill_fields[] = {
    {"shape", into<&F::shape, name>, required},
    {"material", into<&F::material, name>, required},
    {"count", into<&F::count, count>, required},
    {"size", into<&F::size, size_range>},
    {"box", read_corners, required},
    {"seed", into<&F::seed, seed>},
};

}  // namespace

void read_body(const Node& node, BodyDescription& body) {
    read_fields(node, body_fields, body);
}

void read_fill(const Node& node, FillDescription& fill) {
    read_fields(node, fill_fields, fill);
}

}  // namespace scree
