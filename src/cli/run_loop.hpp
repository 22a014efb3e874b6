#pragma once

#include <optional>

#include "commands.hpp"
#include "recorder.hpp"

namespace scree {

/// What is left of a run, up to the last output time that is no later than `until` [s], or the scene's end;
/// with progress on a terminal and a closing line unless quiet. Returns how it ended.
ExitStatus run_to_end(Simulation& simulation, Recorder& recorder, std::optional<double> until, bool quiet);

}  // namespace scree
