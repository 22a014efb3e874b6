#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <scree/contact/material.hpp>
#include <scree/dynamics/prescribed_motion.hpp>
#include <scree/overlap/shape.hpp>
#include <scree/scenes/scene_options.hpp>

namespace scree {

using MaterialDescription = Material;  ///< a material of the file, by the same names

/// Replaces those of the mixed constants of two materials that it names.
struct PairDescription {
    std::array<std::string, 2> materials;  ///< by name
    std::optional<double> youngs_modulus;  ///< [Pa]
    std::optional<double> friction,        ///< μ
        normal_damping,                    ///< γn
        tangential_damping,                ///< γt
        tangential_ratio;                  ///< Yt/Y
    std::optional<bool> torsion;           ///< about the normal
    bool patch_friction = false;           ///< where torsion is named
    std::optional<double> cohesion,        ///< [N]
        rolling_friction,                  ///< μ_r
        kinetic_friction;                  ///< μ while it slides
};

/// What stands for a mesh.
enum class Parts {
    hull,       ///< the mesh's convex hull
    decompose,  ///< convex pieces that together come near the mesh
    files,      ///< one convex part a file
    surface,    ///< the surface itself, as ground of any shape
};

/// A shape from a mesh file.
struct MeshShape {
    std::filesystem::path file;                     ///< relative to the scene's file
    Vec3 scale = Vec3::Ones();                      ///< [m] per unit of the file, by axis
    Parts parts = Parts::hull;                      ///< what stands for the mesh
    std::vector<std::filesystem::path> part_files;  ///< of Parts::files, relative to the scene's file
};

/// A box about its centre.
struct BoxShape {
    Vec3 edges = Vec3::Zero();  ///< [m], full lengths
};

using ShapeDescription = std::variant<MeshShape, BoxShape, Sphere, HalfSpace>;  ///< a shape of the file

struct DynamicMotion {};  ///< moved by forces
struct FixedMotion {};    ///< not moved at all
/// Or a motion that forces do not change, of the shape's own frame.
using MotionDescription = std::variant<DynamicMotion, FixedMotion, PrescribedMotion>;

/// Position, orientation and velocities are those of the shape's own frame (of the file's, for a mesh).
struct BodyDescription {
    std::string name;                      ///< empty: by shape and number
    std::string shape;                     ///< by name
    std::string material;                  ///< by name
    Vec3 position = Vec3::Zero();          ///< [m]
    Quat orientation = Quat::Identity();   ///< unit
    Vec3 velocity = Vec3::Zero();          ///< [m/s], of the frame's origin; of dynamic bodies only
    Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s], world axes; likewise
    MotionDescription motion;              ///< by forces, none, or prescribed
};

/// Bodies placed at random, without overlap, wholly inside a box.
struct FillDescription {
    std::string shape;                 ///< by name
    std::string material;              ///< by name
    std::size_t count = 0;             ///< how many bodies
    std::array<double, 2> size{1, 1};  ///< least and largest factor on the shape's lengths
    Vec3 low = Vec3::Zero();           ///< [m], corners of the box
    Vec3 high = Vec3::Zero();          ///< [m]
    std::uint64_t seed = 1;            ///< of the random numbers
};

/// All that a scene file says, with the defaults of what it leaves out.
struct SceneDescription {
    std::string name;            ///< of the scene
    std::filesystem::path file;  ///< where it was read; meshes are found beside it
    std::string text;            ///< JSON that says the same, with what was set from outside; empty: none
    Vec3 gravity{0, 0, -9.81};   ///< [m/s²]
    std::map<std::string, MaterialDescription> materials;  ///< by name
    std::vector<PairDescription> pairs;                    ///< overrides of the mixing rules
    std::map<std::string, ShapeDescription> shapes;        ///< by name
    std::vector<BodyDescription> bodies;                   ///< placed one by one
    std::vector<FillDescription> fill;                     ///< bodies placed at random
    LawDescription law;                                    ///< of the contacts
    SteppingDescription stepping;                          ///< of the bodies
    double end_time = 0;                                   ///< [s]
    OutputDescription output;                              ///< what is written
};

}  // namespace scree
