#pragma once

#include <optional>

#include <scree/overlap/overlap.hpp>

#include <tests/support/solids.hpp>

namespace scree::test {

/// A shape and where it is.
struct Placed {
    Shape shape;
    Pose pose;
};

inline Placed placed(const Shape& shape, const Vec3& position, const Quat& orientation = Quat::Identity()) {
    return {shape, {position, orientation}};
}

/// The solid z < 0.
inline Placed ground() {
    return {HalfSpace{}, {}};
}

inline Placed moved(const Placed& body, const Pose& motion) {
    return {body.shape, motion * body.pose};
}

/// A body after the small motion ξ = (u, θ) about a point.
inline Placed moved(const Placed& body, const Vec3& about, const Eigen::VectorXd& xi) {
    const Quat turn = rotation(xi.tail<3>());
    return {body.shape,
            {about + xi.head<3>() + turn * (body.pose.position - about), turn * body.pose.orientation}};
}

/// The overlap with everything in world coordinates, the centroid too.
inline std::optional<ContactGeometry> overlap_of(const Placed& a, const Placed& b,
                                                 bool was_centre_line = false,
                                                 Detail detail = Detail::derivative) {
    OverlapWorkspace workspace;
    ContactGeometry geometry;
    if (!overlap(a.shape, a.pose, b.shape, b.pose, detail, was_centre_line, workspace, geometry)) {
        return std::nullopt;
    }
    geometry.centroid += a.pose.position;
    return geometry;
}

/// Every number of a geometry is finite.
inline bool finite(const ContactGeometry& g) {
    return std::isfinite(g.volume) && std::isfinite(g.area) && std::isfinite(g.depth) &&
           std::isfinite(g.lever) && g.centroid.allFinite() && g.area_vector.allFinite() &&
           g.normal.allFinite() && g.first_moment.allFinite() && g.second_moment.allFinite() &&
           g.boundary.allFinite() && g.normal_rate.allFinite();
}

/// The largest entry of a difference, over a size.
template <class A, class B>
double deviation(const A& value, const B& expected, double size) {
    return (value - expected).cwiseAbs().maxCoeff() / size;
}

}  // namespace scree::test
