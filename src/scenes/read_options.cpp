#include "option_words.hpp"
#include "readers.hpp"
#include "values.hpp"

namespace scree {

namespace {

constexpr double default_bullet_step = 1.0 / 240;  // s

using L = LawDescription;
constexpr Field<L> law_fields[] = {
    {"normal", into<&L::normal, choice<normal_laws>>},
    {"friction", into<&L::friction, choice<friction_laws>>},
    {"damping", into<&L::damping, choice<damping_places>>},
    {"normal_damping", into<&L::normal_damping, choice<normal_dampings>>},
    {"tangential_stiffness", into<&L::tangential_stiffness, choice<tangential_stiffnesses>>},
    {"co_rotation", into<&L::co_rotation, flag>},
    {"reduced_mass", into<&L::reduced_mass, choice<reduced_masses>>},
};

int order(const Node& node) {
    if (!node.value().is_number_unsigned() || node.value() < 1U || node.value() > 5U) {
        node.refuse("a whole number from 1 to 5");
    }
    return node.value().get<int>();
}

int iterations(const Node& node) {
    constexpr unsigned most = 1'000'000;
    if (!node.value().is_number_unsigned() || node.value() < 1U || node.value() > most) {
        node.refuse("a whole number from 1 to " + std::to_string(most));
    }
    return node.value().get<int>();
}

int friction_directions(const Node& node) {
    if (!node.value().is_number_unsigned() || node.value() < 1U || node.value() > 2U) {
        node.refuse("1 or 2");
    }
    return node.value().get<int>();
}

void read_step(const Node& node, SteppingDescription& stepping) {
    if (node.value() == "adaptive") {
        stepping.step.reset();
    } else if (node.value().is_string()) {
        node.refuse("\"adaptive\" or a number above 0");
    } else {
        stepping.step = positive(node);
    }
}

using S = SteppingDescription;
constexpr Field<S> stepping_fields[] = {
    {"method", into<&S::method, choice<stepping_methods>>},
    {"max_order", into<&S::max_order, order>},
    {"step", read_step},
    {"rtol", into<&S::rtol, fraction>},
    {"atol", into<&S::atol, fraction>},
    {"solver", into<&S::solver, choice<solver_choices>>},
    {"sleep", into<&S::sleep, flag>},
    {"iterations", into<&S::iterations, iterations>},
    {"separating_axis", into<&S::separating_axis, flag>},
    {"friction_directions", into<&S::friction_directions, friction_directions>},
};

using O = OutputDescription;
constexpr Field<O> output_fields[] = {
    {"every", into<&O::every, positive>},
    {"bodies", into<&O::bodies, flag>},
    {"energy", into<&O::energy, flag>},
    {"contacts", into<&O::contacts, flag>},
    {"replay", into<&O::replay, flag>},
    {"vtk", into<&O::vtk, flag>},
    {"checkpoint_every", into<&O::checkpoint_every, not_negative>},
};

}  // namespace

void read_law(const Node& node, LawDescription& law) {
    read_fields(node, law_fields, law);
}

void read_stepping(const Node& node, SteppingDescription& stepping) {
    read_fields(node, stepping_fields, stepping);
    const bool explicit_method =
        stepping.method == SteppingMethod::verlet || stepping.method == SteppingMethod::symplectic_euler;
    if (explicit_method && !stepping.step) {
        node.refuse("no fixed step", "\"step\": a number of seconds, which this method needs");
    }
    if (stepping.method == SteppingMethod::bullet && !stepping.step) {
        stepping.step = default_bullet_step;
    }
    for (const char* key : {"iterations", "separating_axis", "friction_directions"}) {
        if (stepping.method != SteppingMethod::bullet && node.value().contains(key)) {
            Node(node, key).refuse("it only with \"method\": \"bullet\"");
        }
    }
}

void read_output(const Node& node, OutputDescription& output) {
    read_fields(node, output_fields, output);
}

}  // namespace scree
