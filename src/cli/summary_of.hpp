#pragma once

#include <vector>

#include <scree/output/run_summary.hpp>
#include <scree/scenes/simulation.hpp>

namespace scree {

/// Where all bodies of a simulation are, in scene order.
std::vector<BodyRecord> body_records(const Simulation& simulation);

/// What a simulation has done so far; status and the times of the run itself are left to the caller.
RunSummary summary_of(const Simulation& simulation);

}  // namespace scree
