#pragma once

#include <string>

#include <scree/bdf/statistics.hpp>
#include <scree/dynamics/energy.hpp>

namespace scree {

/// Wall time [s] by stage.
struct StageTimes {
    double detection = 0;  ///< bounds, broadphase, pair list
    double stepping = 0;   ///< everything else in a tick between reading and writing the bodies
};
void visit_state(auto& with, StateOf<StageTimes> auto& times) {
    auto& [detection, stepping] = times;
    with(detection, stepping);
}

/// What a world's ticks have done since it was made.
struct StepReport {
    bool failed = false;    ///< a tick could not be finished; the bodies stand at the last accepted step
    std::string message;    ///< why
    double time = 0;        ///< [s] simulated
    std::size_t ticks = 0;  ///< that were finished
    /// Of the group with the most steps between each two meetings of all: how many the run needs.
    SteppingStatistics steps;
    SteppingStatistics all_steps;  ///< of all groups together: what they cost
    std::size_t pair_searches =
        0;  ///< for candidate pairs; more than one a tick where bodies left their cover
    std::size_t manifold_pairs = 0;  ///< handed to Bullet's narrowphase to bring manifolds up to date
    std::size_t contacts = 0;        ///< touching now
    std::size_t most_contacts = 0;   ///< at the end of a tick
    double largest_overlap = 0;      ///< δ over the smaller body's radius ℓ, over the ends of all ticks
    EnergyLedger energy;  ///< changes from outside, bodies come and gone among them, are work applied
    Vec3 momentum_residual = Vec3::Zero();  ///< momentum less the impulse received [kg m/s]
    StageTimes times;                       ///< summed over all ticks
};
/// Of a world that has not failed.
void visit_state(auto& with, StateOf<StepReport> auto& report) {
    auto& [failed, message, time, ticks, steps, all_steps, pair_searches, manifold_pairs, contacts,
           most_contacts, largest_overlap, energy, momentum_residual, times] = report;
    with(time, ticks, steps, all_steps, pair_searches, manifold_pairs, contacts, most_contacts,
         largest_overlap, energy, momentum_residual, times);
}

}  // namespace scree
