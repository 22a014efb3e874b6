#include <scree/bdf/error_norm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

ErrorScale::ErrorScale(std::span<const Body> bodies, std::span<const TrialBody> trial, double gravity)
    : bodies_(bodies), speed_(bodies.size()) {
    double fastest = std::numeric_limits<double>::min();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const double rim = trial[b].spin.norm() * bodies[b].radius;
        fastest = std::max({fastest, trial[b].velocity.norm(), bodies[b].dynamic() ? rim : 0});
    }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const double falling = std::sqrt(gravity * bodies[b].radius);
        speed_[b] = std::max(trial[b].velocity.norm(), falling > 0 ? falling : fastest);
    }
}

double ErrorScale::norm(std::size_t body, const BodyError& error) const {
    const double size = bodies_[body].radius;
    const double speed = speed_[body];
    const double sum = error.position.squaredNorm() / (size * size) + error.angle.squaredNorm() +
                       error.velocity.squaredNorm() / (speed * speed) +
                       error.spin.squaredNorm() * size * size / (speed * speed);
    return std::sqrt(sum / 12);
}

}  // namespace scree
