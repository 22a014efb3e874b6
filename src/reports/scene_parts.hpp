#pragma once

#include <filesystem>
#include <string>

#include <scree/scenes/scene_description.hpp>

namespace scree {

// Pieces that the scenes of the reports are put together from.

constexpr double earth_gravity = 9.81;  // [m/s²]

/// A scene without bodies, of one material, "rock", seen at `looks` output times.
SceneDescription bare_scene(const std::string& name, double end_time, int looks);

/// A mesh that comes with scree, times a scale.
MeshShape shipped_mesh(const std::string& name, double scale);

/// A dynamic body of rock, its frame at a position.
BodyDescription& add_body(SceneDescription& scene, const std::string& shape, const Vec3& position);
/// A fixed one.
BodyDescription& add_fixed(SceneDescription& scene, const std::string& shape, const Pose& pose);
/// The half-space below z = 0, fixed.
BodyDescription& add_floor(SceneDescription& scene);

/// The depth [m] to which a face of a body sinks into the ground under a load [N], Eq. (5.7): F Lc/(Y A), Lc
/// being the diameter of the sphere of the body's volume.
double sunk_depth(double load, double volume, double area, double youngs_modulus);

/// A direction in the x–y plane that is along no axis.
Vec3 odd_direction();

/// Where the meshes of a report are while it is made.
std::filesystem::path meshes_folder(const std::filesystem::path& report);

/// Writes points spread over an ellipsoid of half axes 0.5, 0.45 and 0.4 as a mesh whose hull is the stone.
std::filesystem::path write_round_stone(const std::filesystem::path& report, int points);

}  // namespace scree
