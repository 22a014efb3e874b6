#pragma once

#include <scree/overlap/round_shape.hpp>

namespace scree {

/// Where a convex solid is nearest to a point: its frame, outward.
struct NearestFeature {
    Vec3 normal = Vec3::UnitZ();  ///< from the surface to the point; of the nearest face for a point inside
    double height = 0;            ///< [m], of the point above the surface; negative inside
    Mat3 normal_rate =
        Mat3::Zero();  ///< dn by the motion of the point [1/m]: the curvature of edge or vertex
};

NearestFeature nearest_feature(const ConvexPolyhedron& solid, const Vec3& point);

/// On the true surfaces of revolution, not on facets.
NearestFeature nearest_feature(const Frustum& frustum, const Vec3& point);
NearestFeature nearest_feature(const Capsule& capsule, const Vec3& point);

}  // namespace scree
