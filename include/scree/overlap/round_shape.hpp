#pragma once

#include <scree/mesh/convex_polyhedron.hpp>

namespace scree {

/// A solid of revolution about the z axis with straight sides, centred between its ends: a cylinder, a cone
/// or a cone cut short.
struct Frustum {
    double bottom = 0;       ///< [m], radius of the end at z = −half_height
    double top = 0;          ///< [m], radius of the end at z = half_height; one of the two may be 0
    double half_height = 0;  ///< [m]
    /// The same solid over a polygon, which is what is clipped. The polygon is finest where the x axis meets
    /// it, and the overlap turns it about z until x points to where the contact is: so a spin about z changes
    /// nothing, and nothing is faceted at the scale of a contact.
    ConvexPolyhedron facets;

    /// Radius [m] at a height.
    [[nodiscard]] double radius_at(double z) const {
        return 0.5 * (bottom + top + (top - bottom) * z / half_height);
    }
};

/// Throws std::invalid_argument for sizes that are not finite or negative, and a solid without volume.
Frustum make_frustum(double bottom, double top, double half_height);

/// All points within a radius of a piece of the z axis about the origin.
struct Capsule {
    double radius = 0;       ///< [m]
    double half_length = 0;  ///< [m], of the piece of axis
    ConvexPolyhedron side;   ///< the part between the two round ends, as Frustum::facets
};

/// Throws std::invalid_argument for sizes that are not finite and positive.
Capsule make_capsule(double radius, double half_length);

}  // namespace scree
