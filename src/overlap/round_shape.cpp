#include <scree/overlap/round_shape.hpp>

#include <cmath>
#include <stdexcept>

#include "graded_disc.hpp"

namespace scree {

namespace {

using Loop = std::vector<int>;

/// The corners of one end: a polygon, or the tip of a cone.
struct End {
    Loop corners;

    End(double radius, double height, std::vector<Vec3>& vertices) {
        const auto add = [&](const Vec3& vertex) {
            corners.push_back(static_cast<int>(vertices.size()));
            vertices.push_back(vertex);
        };
        if (radius == 0) {
            add({0, 0, height});
            return;
        }
        for (const Eigen::Vector2d& corner : graded_disc()) {
            add({radius * corner.x(), radius * corner.y(), height});
        }
    }
    [[nodiscard]] bool tip() const { return corners.size() == 1; }
    [[nodiscard]] int at(std::size_t i) const { return corners[tip() ? 0 : i % corners.size()]; }
};

ConvexPolyhedron make_facets(double bottom, double top, double half_height) {
    std::vector<Vec3> vertices;
    const End low(bottom, -half_height, vertices);
    const End high(top, half_height, vertices);
    std::vector<Loop> faces;
    if (!low.tip()) {
        faces.emplace_back(low.corners.rbegin(), low.corners.rend());
    }
    if (!high.tip()) {
        faces.push_back(high.corners);
    }
    for (std::size_t i = 0; i < graded_disc().size(); ++i) {
        Loop side{low.at(i)};
        if (!low.tip()) {
            side.push_back(low.at(i + 1));
        }
        side.push_back(high.at(i + 1));
        if (!high.tip()) {
            side.push_back(high.at(i));
        }
        faces.push_back(side);
    }
    return make_polyhedron(std::move(vertices), faces);
}

}  // namespace

Frustum make_frustum(double bottom, double top, double half_height) {
    const bool finite = std::isfinite(bottom) && std::isfinite(top) && std::isfinite(half_height);
    if (!finite || bottom < 0 || top < 0 || !(bottom + top > 0) || !(half_height > 0)) {
        throw std::invalid_argument("a cylinder or cone needs a radius and a height above 0");
    }
    return {bottom, top, half_height, make_facets(bottom, top, half_height)};
}

Capsule make_capsule(double radius, double half_length) {
    if (!std::isfinite(radius) || !std::isfinite(half_length) || !(radius > 0) || !(half_length > 0)) {
        throw std::invalid_argument("a capsule needs a radius and a length above 0");
    }
    return {radius, half_length, make_facets(radius, radius, half_length)};
}

}  // namespace scree
