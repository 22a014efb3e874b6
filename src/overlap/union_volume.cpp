#include <scree/overlap/union_volume.hpp>

#include <algorithm>

#include <scree/overlap/clip.hpp>

#include "patch.hpp"

namespace scree {

namespace {

double volume_of(const ClippedSolid& solid) {
    ContactGeometry geometry;
    integrate_volume(solid, geometry);
    return std::max(geometry.volume, 0.0);
}

// Of what lies outside of the first `count` solids.
double outside(ClippedSolid piece, std::span<const ConvexPolyhedron> solids, std::size_t count) {
    if (count == 0) {
        return volume_of(piece);
    }
    double sum = 0;
    for (const Plane& plane : solids[count - 1].planes) {
        ClippedSolid beyond = piece;
        if (beyond.cut({-plane.normal, -plane.offset}, 0)) {
            sum += outside(std::move(beyond), solids, count - 1);
        }
        if (!piece.cut(plane, 0)) {
            break;
        }
    }
    return sum;
}

}  // namespace

double union_volume(std::span<const ConvexPolyhedron> solids) {
    double sum = 0;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        ClippedSolid whole;
        whole.start(solids[i]);
        sum += outside(std::move(whole), solids, i);
    }
    return sum;
}

}  // namespace scree
