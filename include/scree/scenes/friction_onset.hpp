#pragma once

#include <vector>

#include <scree/scenes/scene_description.hpp>

namespace scree {

/// A flat tile let go at rest on a slope that holds it, Fig. 5.16: its tangential spring has to stretch
/// before it carries the tile. As long as nothing slips this is a damped oscillator under a steady pull.
struct FrictionOnset {
    double tangential_damping = 0;        ///< γt; 2 is critical
    double tangential_ratio = 2.0 / 7.0;  ///< Yt/Y
    double youngs_modulus = 1e8;          ///< [Pa]
    LawOptions law;                       ///< of the tile on its slope
};

/// The scene, for a run of `duration` [s] with output times `every` [s]; the tile has sunk in as deep as it
/// rests.
SceneDescription friction_onset_scene(const FrictionOnset& onset, double duration, double every);

/// Of the tile [kg].
double onset_mass();
/// ω = √(kt/m) [rad/s] of the tile on its spring.
double onset_frequency(const FrictionOnset& onset);
/// ζ = γt/2, for a tile yields with all of its mass.
double onset_damping_ratio(const FrictionOnset& onset);
/// The exact force of the spring over the pull m g sin θ, at a time [s].
double onset_spring(const FrictionOnset& onset, double time);

/// The force of the spring over the pull, as it was stored at the output times.
struct OnsetRun {
    std::vector<double> time;    ///< [s]
    std::vector<double> spring;  ///< over the pull
    bool slipped = false;        ///< the tile was at its limit at some output time
};
/// So many output times in each of so many periods 2π/ω. Throws SceneError.
OnsetRun run_friction_onset(const FrictionOnset& onset, double periods, int samples);

/// When the spring of a run first carries a share of the pull [s], between two output times; NaN for never.
double onset_delay(const OnsetRun& run, double share);

}  // namespace scree
