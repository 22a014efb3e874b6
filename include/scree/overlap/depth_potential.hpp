#pragma once

#include <scree/overlap/overlap.hpp>

namespace scree {

/// ∫ e dV over the overlap P of two convex polyhedra, where e is twice the distance from the surface of P,
/// and its derivatives. Between two faces that is half the depth squared over the area, as against a
/// half-space; a force that is its gradient does no work round any closed path. World axes.
struct DepthPotential {
    double value = 0;            ///< [m⁴]
    Vec3 force = Vec3::Zero();   ///< [m³], −d(value) by a translation of A; about V n
    Vec3 moment = Vec3::Zero();  ///< [m⁴], −d(value) by a turn of A about the overlap's centroid
    /// d(force, moment) = rate · ξ as in ContactGeometry, the second part with the reference point held at
    /// the centroid.
    Mat6 rate = Mat6::Zero();
};

/// Of the last overlap that the workspace was used for, of two polyhedra, with `pose_a` the pose of A's
/// shape.
///
/// P is cut into cells, one for each of its faces, of the points that are nearest to that face. In the cell
/// of a face of B e grows along B's inward normal, so that A is pushed the other way.
void depth_potential(const ConvexPolyhedron& a, const Pose& pose_a, const ContactGeometry& geometry,
                     Detail detail, OverlapWorkspace& workspace, DepthPotential& potential);

}  // namespace scree
