#pragma once

#include <scree/scenes/scene_description.hpp>

#include "fields.hpp"

namespace scree {

// The parts of a scene file.
void read_material(const Node& node, MaterialDescription& material);
void read_pair(const Node& node, PairDescription& pair);
void read_shape(const Node& node, ShapeDescription& shape);
void read_body(const Node& node, BodyDescription& body);
void read_fill(const Node& node, FillDescription& fill);
void read_law(const Node& node, LawDescription& law);
void read_stepping(const Node& node, SteppingDescription& stepping);
void read_output(const Node& node, OutputDescription& output);

/// Refuses what the scene file may say but this build cannot do.
void check_in_this_build(const Json& scene);

}  // namespace scree
