#pragma once

#include <string>
#include <vector>

#include <scree/scenes/simulation.hpp>

namespace scree {

/// What a run of the scene will use and what it leaves out, for a human to read: a line each, "word: text".
std::vector<std::string> describe_scene(const Simulation& simulation);

}  // namespace scree
