#include "manifold_writer.hpp"

#include <algorithm>
#include <limits>

#include <scree/detect/convert.hpp>

namespace scree {

namespace {

/// The points of a manifold that no new one is going to replace.
class Leftovers {
  public:
    Leftovers(std::span<const ContactPoint> points, const btPersistentManifold& manifold) {
        std::array<bool, ContactPoints::most> kept{};
        for (const ContactPoint& point : points) {
            if (const int old = nearest(to_bullet(point.on_a), manifold, kept); old >= 0) {
                kept[static_cast<std::size_t>(old)] = true;
            }
        }
        for (int i = manifold.getNumContacts(); i-- > 0;) {
            if (!kept[static_cast<std::size_t>(i)]) {
                numbers_[count_++] = i;
            }
        }
    }
    /// Highest first, so that removing one leaves the numbers of the others as they are.
    [[nodiscard]] std::span<const int> numbers() const { return std::span(numbers_).first(count_); }

  private:
    // By the point on the first body, in its frame, as Bullet compares them.
    static int nearest(const btVector3& on_a, const btPersistentManifold& manifold,
                       const std::array<bool, ContactPoints::most>& taken) {
        const btVector3 local = manifold.getBody0()->getWorldTransform().invXform(on_a);
        const double threshold = manifold.getContactBreakingThreshold();
        double least = threshold * threshold;
        int found = -1;
        for (int i = 0; i < manifold.getNumContacts(); ++i) {
            const double distance = (manifold.getContactPoint(i).m_localPointA - local).length2();
            if (!taken[static_cast<std::size_t>(i)] && distance < least) {
                least = distance;
                found = i;
            }
        }
        return found;
    }

    std::array<int, ContactPoints::most> numbers_{};
    std::size_t count_ = 0;
};

}  // namespace

void write_points(std::span<const ContactPoint> points, const btVector3& normal,
                  btPersistentManifold& manifold, btManifoldResult& result) {
    if (points.empty()) {
        manifold.clearManifold();
        return;
    }
    const Leftovers leftovers(points, manifold);
    const std::span<const int> old = leftovers.numbers();
    // A manifold that is emptied on the way would tell its listeners that the contact has ended.
    const bool all_go = static_cast<int>(old.size()) == manifold.getNumContacts();
    const std::size_t kept_for_now = all_go && !old.empty() ? 1 : 0;
    for (std::size_t i = 0; i + kept_for_now < old.size(); ++i) {
        manifold.removeContactPoint(old[i]);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.addContactPoint(normal, to_bullet(points[i].on_b), -points[i].depth);
        if (i == 0 && kept_for_now > 0) {
            manifold.removeContactPoint(0);
        }
    }
    result.refreshContactPoints();
}

}  // namespace scree
