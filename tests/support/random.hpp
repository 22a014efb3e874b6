#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <scree/mesh/convex_hull.hpp>

namespace scree::test {

/// Seeded draws, the same on every machine (the standard's distributions are not).
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [low, high).
    double uniform(double low = 0, double high = 1) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }

    /// Each component uniform in [low, high).
    Vec3 vector(double low = -1, double high = 1) {
        const double x = uniform(low, high);
        const double y = uniform(low, high);
        return {x, y, uniform(low, high)};
    }

    /// Uniform on the unit sphere.
    Vec3 direction() {
        for (;;) {
            const Vec3 v = vector();
            const double square = v.squaredNorm();
            if (square <= 1 && square > 1e-6) {
                return v / std::sqrt(square);
            }
        }
    }

    /// Uniform over all rotations: the direction of a uniform point in the four-dimensional ball.
    Quat rotation() {
        for (;;) {
            const Vec3 v = vector();
            const Quat q(uniform(-1, 1), v.x(), v.y(), v.z());
            if (q.squaredNorm() <= 1 && q.squaredNorm() > 1e-6) {
                return q.normalized();
            }
        }
    }

    /// The hull of `points` random points between half the radius and the radius [m] from the origin.
    ConvexPolyhedron polyhedron(int points = 12, double radius = 1) {
        std::vector<Vec3> cloud;
        for (int i = 0; i < points; ++i) {
            cloud.emplace_back(direction() * uniform(radius / 2, radius));
        }
        return convex_hull(cloud).solid;
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace scree::test
