#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <scree/scenes/scene_description.hpp>
#include <scree/world/dynamics_world.hpp>

namespace scree {

/// A convex part of a solid.
struct SolidPart {
    std::shared_ptr<const Shape> shape;  ///< in its own frame
    Vec3 position = Vec3::Zero();        ///< of its frame in the body's [m]; the axes are the body's
};

/// A shape of a scene, ready to become bodies. The body's frame has the mass centre as origin and principal
/// axes; the file's frame is the one that position and orientation place.
struct Solid {
    std::shared_ptr<const Shape> shape;           ///< in the body's frame; of parts the hull
    std::vector<SolidPart> parts;                 ///< empty: the shape is the only one
    std::shared_ptr<btCollisionShape> collision;  ///< the same for the pair search
    std::shared_ptr<btCollisionShape> native;     ///< the same as Bullet's own solver knows it best
    Pose body_in_file;                            ///< the body's frame, seen from the file's
    double volume = 0;                            ///< [m³]; infinite for a half-space and a surface
    Vec3 inertia = Vec3::Zero();                  ///< principal, for density 1 [m⁵]
    std::string note;                             ///< where the solid is not what the file says
};

/// Calls visit(shape, position) for each convex part, in the body's frame.
template <class Visit>
void for_each_part(const Solid& solid, Visit&& visit) {
    if (solid.parts.empty()) {
        visit(*solid.shape, Vec3(Vec3::Zero()));
    }
    for (const SolidPart& part : solid.parts) {
        visit(*part.shape, part.position);
    }
}

/// Loads the mesh, if it is one. Throws std::exception, saying why it is no solid.
Solid make_solid(const ShapeDescription& shape, const std::filesystem::path& folder);

/// All that the motion of a body of this shape depends on, to tell it from another one.
SavedState geometry_of(const Solid& solid);

/// The same solid with all lengths multiplied by `factor`.
Solid scaled(const Solid& solid, double factor);

}  // namespace scree
