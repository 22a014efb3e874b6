#include "loop_normal.hpp"

#include <algorithm>

namespace scree {

namespace {

/// Takes out of the normal the slope that the vertices' heights have along one direction.
Vec3 levelled(const Vec3& normal, const std::vector<Vec3>& arms, const Vec3& along) {
    double rise = 0;
    double run = 0;
    for (const Vec3& arm : arms) {
        rise += normal.dot(arm) * along.dot(arm);
        run += along.dot(arm) * along.dot(arm);
    }
    return run > 0 ? Vec3((normal - rise / run * along).normalized()) : normal;
}

}  // namespace

Vec3 loop_normal(const std::vector<Vec3>& points, const std::vector<int>& loop) {
    Vec3 middle = Vec3::Zero();
    for (const int v : loop) {
        middle += points[v] / static_cast<double>(loop.size());
    }
    std::vector<Vec3> arms;
    for (const int v : loop) {
        arms.emplace_back(points[v] - middle);
    }
    Vec3 area = Vec3::Zero();
    Vec3 longest = Vec3::Zero();
    for (std::size_t i = 0; i < arms.size(); ++i) {
        area += arms[i].cross(arms[(i + 1) % arms.size()]);
        longest = arms[i].squaredNorm() > longest.squaredNorm() ? arms[i] : longest;
    }
    // A height of a few roundings of the length says nothing about the normal.
    if (!(area.norm() > 1e-14 * longest.squaredNorm())) {
        return Vec3::Zero();
    }
    Vec3 normal = area.normalized();
    for (int sweep = 0; sweep < 2; ++sweep) {
        normal = levelled(normal, arms, longest.normalized());
        normal = levelled(normal, arms, normal.cross(longest).normalized());
    }
    return normal;
}

}  // namespace scree
