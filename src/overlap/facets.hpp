#pragma once

#include <scree/overlap/contact_geometry.hpp>
#include <scree/overlap/round_shape.hpp>

#include "nearest_direction.hpp"

namespace scree {

/// How the facets of a solid of revolution are turned, so that their finest ones are where the contact is.
struct FacetPose {
    Pose pose;  ///< of the facets, world axes
    Vec3 axis;  ///< of the solid, unit, world axes
    /// When the body turns by θ, the facets turn by θ − (spin·θ) axis.
    Eigen::RowVector3d spin;
};

/// Where facets are to face to, both unit and fixed to the other body: along the part of `toward` across the
/// axis or, where next to nothing is left of that, as under a cylinder on its end, along that of `otherwise`.
struct Facing {
    Vec3 toward, otherwise;
};
/// Given the unit direction from the other body's nearest point to this one, in the other body's frame.
Facing facing(const Vec3& direction, const Quat& other);

FacetPose facet_pose(const Pose& pose, const Facing& facing);

/// Takes the spin of the facets against the body out of the rates of an overlap of the facets, which is in
/// world axes with the origin on the axis, and the axis out of its moments.
void follow_facets(const FacetPose& facets, ContactGeometry& geometry);

/// The projection across an axis.
Mat3 without(const Vec3& axis);

/// The facets of a solid of revolution in its own frame, and a piece of the axis that is well inside.
struct Faceted {
    const ConvexPolyhedron& solid;
    Segment core;
};
Faceted faceted(const Frustum& frustum);
/// Of the part between the ends.
Faceted faceted(const Capsule& capsule);

}  // namespace scree
