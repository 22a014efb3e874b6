#pragma once

#include <span>
#include <string>
#include <string_view>

#include <scree/output/pose_spool.hpp>
#include <scree/output/shown_scene.hpp>

namespace scree {

// Binary glTF 2 by assimp's exporter. One node a body, named as it is; meshes are shared; the root turns the
// world's z up to y up. Throws std::runtime_error, saying why, for what cannot be exported.

/// The motion of those that move, whose poses the spool has, as an animation. Of long runs every second,
/// third … frame is taken, so that there are no more than `most_poses`. The extras of the animation have the
/// number of contacts of each frame.
std::string replay_glb(const ShownScene& scene, const PoseSpool& spool, std::size_t most_poses = 1'000'000);

/// What a replay shows at a time [s], without motion.
std::string still_of_replay(std::string_view replay, double time);

/// A ball that holds nearly all that a still shows besides ground, in the axes of the file (y up).
struct StillView {
    Vec3 centre = Vec3::Zero();  ///< [m]
    double radius = 1;           ///< [m]
};
/// Of a still in binary glTF, as still_of_replay gives it.
StillView view_of_still(std::string_view still);

/// The same still with colours that are so many times as bright, for a viewer with little light.
std::string brightened(std::string_view still, double factor);

}  // namespace scree
