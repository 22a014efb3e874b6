#pragma once

#include <string>

#include <scree/bdf/stepper.hpp>

namespace scree {

/// Wall time [s] by stage.
struct StageTimes {
    double detection = 0;  ///< bounds, broadphase, pair list
    double stepping = 0;   ///< everything within the steps
};

/// What a world's ticks have done since it was made.
struct StepReport {
    bool failed = false;  ///< a tick could not be finished; the bodies stand at the last accepted step
    std::string message;  ///< why
    double time = 0;      ///< [s] simulated
    SteppingStatistics steps;
    NewtonStatistics newton;
    std::size_t contact_evaluations = 0;
    std::size_t contacts = 0;       ///< touching now
    std::size_t most_contacts = 0;  ///< at the end of a tick
    double largest_overlap = 0;     ///< δ over body size, over all ticks
    StageTimes times;
};

}  // namespace scree
