#pragma once

#include <vector>

#include <scree/overlap/clip.hpp>
#include <scree/overlap/contact_geometry.hpp>
#include <scree/overlap/patch_outline.hpp>
#include <scree/overlap/shape.hpp>

namespace scree {

/// How much of the geometry is wanted.
enum class Detail {
    force,       ///< without `boundary` and `normal_rate`
    derivative,  ///< everything
};

/// A line along the contact normal through an overlap.
struct Chord {
    Vec3 at = Vec3::Zero();  ///< a point of it
    double low = 0;          ///< where it enters, along the normal from there [m]
    double high = 0;         ///< where it leaves [m]

    /// How long [m] the line is inside.
    [[nodiscard]] double depth() const { return high - low; }
};

/// A face of an overlap.
struct OverlapSide {
    Plane plane;  ///< outward, in the frame of what was clipped
    int tag = 0;  ///< of the clipped solid's face
};

/// Buffers of the overlap computation, one a thread.
struct OverlapWorkspace {
    ClippedSolid clipped;            ///< the overlap itself
    std::vector<Plane> planes;       ///< that cut it
    std::vector<Chord> chords;       ///< through the corners of the patch
    PatchOutline outline;            ///< of the overlap along the normal
    std::vector<OverlapSide> sides;  ///< of the overlap
    ClippedSolid cell;               ///< a part of the clipped solid
    Pose frame;                      ///< of what was clipped last
    bool solid = false;  ///< the last overlap left a solid there, all of it but a capsule's round ends
};

/// The overlap of two shapes at their poses, Eq. (5.7)'s V with all that goes with it. Returns false, leaving
/// `geometry` as it was, when they do not overlap. `was_centre_line` is the committed value of
/// geometry.centre_line, for its hysteresis. Throws std::invalid_argument for two half-spaces and for open
/// surfaces.
///
/// A sphere against anything but a sphere or a half-space has the cap of its depth under the other's nearest
/// tangent plane. Cylinders, cones and the sides of capsules are clipped by facets that grow with the
/// distance from the contact: of a contact with a plane, volume and patch are within 0.0014 and 0.01 of the
/// true ones, and those of a whole end on a plane are exact.
bool overlap(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, Detail detail,
             bool was_centre_line, OverlapWorkspace& workspace, ContactGeometry& geometry);

/// The corners [m] of the patch, B's surface inside A, left in the workspace by the last overlap of two
/// shapes of which at least one is a polyhedron: in the frame of the polyhedron that was clipped.
std::vector<Vec3> patch_outline(const OverlapWorkspace& workspace);

}  // namespace scree
