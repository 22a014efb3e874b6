#pragma once

#include <filesystem>
#include <string>

#include <scree/scenes/scene_description.hpp>

namespace scree {

/// A block from a mesh file, lying on its broadest face on a slope: the case that has an exact answer.
struct Incline {
    std::filesystem::path mesh;  ///< of the block
    double scale = 0.1;          ///< [m] per unit of the mesh
    std::filesystem::path
        ground;                ///< mesh of the slope, its upper face level in the file; empty: a half-space
    double ground_scale = 1;   ///< [m] per unit of that mesh
    bool turn_ground = false;  ///< the ground is turned under level gravity; false: gravity is turned
    double azimuth = 0;        ///< [rad], of the downhill direction, in the plane of the slope
    double turn = 0;           ///< [rad], of the block about the slope's normal
    double friction = 0.5;     ///< μ
    double youngs_modulus = 1e9;       ///< [Pa]
    double relative_tolerance = 1e-3;  ///< rtol
};

/// The slope [rad] above which a rigid block slides: atan μ.
double sliding_angle(const Incline& incline);
/// Downhill acceleration [m/s²] of a rigid block that slides: g (sin θ − μ cos θ).
double sliding_acceleration(const Incline& incline, double slope);
/// The slope [rad] above which the block tips over an edge of its lower face, whatever the friction.
double tipping_angle(const Incline& incline);

/// The scene, let go at rest, for a run of `duration` [s]. Throws SceneError for a mesh that is none.
SceneDescription incline_scene(const Incline& incline, double slope, double duration);

/// What the block did, in the frame of the slope: x downhill, z along its normal.
struct InclineRun {
    bool finished = false;              ///< to its end
    std::string message;                ///< why not
    double acceleration = 0;            ///< downhill [m/s²], mean over the second half of the run
    double slide = 0;                   ///< downhill [m]
    double drift = 0;                   ///< sideways [m]
    double creep = 0;                   ///< largest distance [m] from where it was after a fifth of the run
    double turn = 0;                    ///< [rad], from how it started
    double seconds = 0;                 ///< wall time
    std::size_t steps = 0;              ///< accepted
    std::size_t newton_iterations = 0;  ///< in all steps
};
/// Lets the block go at rest on the slope [rad], for `duration` [s]. Throws SceneError.
InclineRun run_incline(const Incline& incline, double slope, double duration);

/// The sliding angle [rad] by bisection, to `tolerance` [rad]: the slope at which the block begins to gain
/// speed in the second half of a run of one second.
struct MeasuredAngle {
    double angle = 0;                   ///< [rad]
    double seconds = 0;                 ///< wall time
    std::size_t runs = 0;               ///< of the bisection
    std::size_t steps = 0;              ///< accepted, of all runs
    std::size_t newton_iterations = 0;  ///< of all runs
};
/// Looks about sliding_angle(). Throws SceneError.
MeasuredAngle measure_sliding_angle(const Incline& incline, double tolerance);

}  // namespace scree
