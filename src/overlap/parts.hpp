#pragma once

#include <span>

#include <scree/overlap/contact_geometry.hpp>

namespace scree {

/// The geometry of an overlap that comes in disjoint parts; all with the same origin. `apart` [m] leads from
/// B's centre to A's.
ContactGeometry whole_of(std::span<const ContactGeometry> parts, const Vec3& apart, bool was_centre_line);

/// A share of an overlap.
void scale(ContactGeometry& geometry, double share);

/// The geometry against a plane that is B's tangent where B is nearest to a point of A, and so turns about
/// B's nearest point when A's moves: dn = normal_rate · motion of A's point, at `point` from the origin and
/// at `height` above the plane.
void follow_tangent(const Mat3& normal_rate, const Vec3& point, double height, ContactGeometry& geometry);

}  // namespace scree
