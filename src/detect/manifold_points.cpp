#include <scree/detect/manifold_points.hpp>

namespace scree {

std::vector<btManifoldPoint> manifold_points(const btPersistentManifold& manifold) {
    std::vector<btManifoldPoint> points;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        points.push_back(manifold.getContactPoint(i));
    }
    return points;
}

void set_manifold_points(const std::vector<btManifoldPoint>& points, btPersistentManifold& manifold) {
    StateReader::require(points.size() <= MANIFOLD_CACHE_SIZE);
    manifold.clearManifold();
    for (const btManifoldPoint& point : points) {
        constexpr bool at_any_distance = true;
        manifold.addManifoldPoint(point, at_any_distance);
    }
}

}  // namespace scree
