#include "mesh_surface.hpp"

#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <algorithm>
#include <cmath>

#include <scree/detect/convert.hpp>

namespace scree {

namespace {

constexpr double at_an_edge = 1e-4;  // of a triangle's size, within which a point is on a neighbour too
constexpr double level = 1e-3;       // sine of an angle that counts as none

struct Gatherer : btTriangleCallback {
    std::vector<MeshSurface::Triangle>& triangles;
    btTransform at;

    Gatherer(std::vector<MeshSurface::Triangle>& into, const btTransform& transform)
        : triangles(into), at(transform) {}
    void processTriangle(btVector3* corners, int /*part*/, int /*index*/) override {
        triangles.push_back(
            {to_eigen(at * corners[0]), to_eigen(at * corners[1]), to_eigen(at * corners[2])});
    }
};

Vec3 area(const MeshSurface::Triangle& t) {
    return (t[1] - t[0]).cross(t[2] - t[0]);
}

double size(const MeshSurface::Triangle& t) {
    return std::sqrt(area(t).norm());
}

double distance_to_edge(const Vec3& from, const Vec3& to, const Vec3& point) {
    const Vec3 along = to - from;
    const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (point - from - share * along).norm();
}

double distance(const MeshSurface::Triangle& t, const Vec3& point) {
    const Vec3 normal = area(t).stableNormalized();
    bool above = true;
    double nearest = std::abs(normal.dot(point - t[0]));
    double edges = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& from = t[i];
        const Vec3& to = t[(i + 1) % 3];
        above = above && normal.cross(to - from).dot(point - from) >= 0;
        edges = std::min(edges, distance_to_edge(from, to, point));
    }
    return above ? nearest : edges;
}

// Whether no corner is above the plane across a direction at a point.
bool below(const MeshSurface::Triangle& t, const Vec3& point, const Vec3& direction) {
    return std::all_of(t.begin(), t.end(), [&](const Vec3& corner) {
        const Vec3 way = corner - point;
        return direction.dot(way) <= level * way.norm();
    });
}

}  // namespace

MeshSurface::MeshSurface(const btConcaveShape& shape, const btTransform& at, const btVector3& low,
                         const btVector3& high) {
    Gatherer gatherer(triangles_, at);
    shape.processAllTriangles(&gatherer, low, high);
}

MeshSurface::Triangle MeshSurface::triangle(const btCollisionObjectWrapper& wrap) {
    const auto& shape = *static_cast<const btTriangleShape*>(wrap.getCollisionShape());
    const btTransform& at = wrap.getWorldTransform();
    return {to_eigen(at * shape.m_vertices1[0]), to_eigen(at * shape.m_vertices1[1]),
            to_eigen(at * shape.m_vertices1[2])};
}

std::optional<Vec3> MeshSurface::direction(const Triangle& triangle, const Vec3& point, const Vec3& found,
                                           const Vec3& other) const {
    const Vec3 normal = area(triangle).stableNormalized();
    const Vec3 across = normal.dot(other - triangle[0]) < 0 ? Vec3(-normal) : normal;
    if (across.dot(found) < 0) {
        return std::nullopt;
    }
    if (across.dot(found) > 1 - 0.5 * level * level) {
        return found;
    }
    const double near = at_an_edge * size(triangle);
    const bool free = std::all_of(triangles_.begin(), triangles_.end(), [&](const Triangle& neighbour) {
        return distance(neighbour, point) > near || below(neighbour, point, found);
    });
    return free ? found : across;
}

}  // namespace scree
