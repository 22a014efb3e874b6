#pragma once

#include <scree/mesh/convex_polyhedron.hpp>
#include <scree/mesh/triangle_mesh.hpp>

namespace scree {

/// Of a solid of density 1 kg/m³.
struct MassProperties {
    double volume = 0;                       ///< [m³]
    Vec3 centroid = Vec3::Zero();            ///< [m]
    Mat3 inertia = Mat3::Zero();             ///< [m⁵], about the centroid, axes of the given frame
    Vec3 principal_inertia = Vec3::Zero();   ///< [m⁵], about the principal axes
    Quat principal_axes = Quat::Identity();  ///< from the principal frame, nearest to the given one, to that
};

/// By the divergence theorem over the surface, exact for polyhedra. The surface must be closed and outward;
/// throws std::invalid_argument when its volume is not positive.
MassProperties mass_properties(const ConvexPolyhedron& solid);
/// Of the solid that a closed triangle mesh encloses.
MassProperties mass_properties(const TriangleMesh& surface);

/// Radius [m] of the sphere of a given volume [m³].
double sphere_radius(double volume);

}  // namespace scree
