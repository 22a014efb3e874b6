#pragma once

#include <span>

#include <scree/overlap/clip.hpp>
#include <scree/overlap/contact_geometry.hpp>

namespace scree {

/// The planes whose faces bound an overlap: A's own, and B's in A's frame.
struct OverlapPlanes {
    std::span<const Plane> a;
    std::span<const Plane> b;

    [[nodiscard]] const Plane& plane(int tag) const;
    [[nodiscard]] const Vec3& normal(int tag) const { return plane(tag).normal; }
};

/// V and c of what is left, by the divergence theorem about one of its own vertices; returns the surface
/// [m²].
double integrate_volume(const ClippedSolid& solid, ContactGeometry& geometry);

/// S and its moments, from the faces that belong to B: the rest of the surface has what is missing to a
/// closed one.
void integrate_patch(const ClippedSolid& solid, const OverlapPlanes& planes, ContactGeometry& geometry);

/// d(S, ∫ r×n_A dA) from the line where A's and B's faces meet.
void integrate_boundary(const ClippedSolid& solid, const OverlapPlanes& planes, ContactGeometry& geometry);

/// δ and r̄, once the normal is known.
void measure_patch(const ClippedSolid& solid, ContactGeometry& geometry);

}  // namespace scree
