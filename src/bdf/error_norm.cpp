#include <scree/bdf/error_norm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

constexpr double usual = 1e-3;  // the tolerance up to which the error of a step is that of a run

}  // namespace

// Order 1 serves only to start, in a number of steps that does not grow as they shrink.
double Tolerances::a_step(std::size_t order) const {
    const double share = std::min(1.0, sum() / usual);
    return sum() * std::pow(share, 1 / static_cast<double>(std::max<std::size_t>(order, 2)));
}

ErrorScale::ErrorScale(std::span<const Body> bodies, std::span<const TrialBody> trial, double gravity)
    : bodies_(bodies),
      trial_(trial),
      gravity_(gravity),
      fastest_(std::sqrt(std::numeric_limits<double>::min())) {
    for (std::size_t b = 0; gravity == 0 && b < bodies.size(); ++b) {
        const double rim = trial[b].spin.norm() * bodies[b].radius;
        fastest_ = std::max({fastest_, trial[b].velocity.norm(), bodies[b].dynamic() ? rim : 0});
    }
}

double ErrorScale::norm(std::size_t body, const BodyError& error) const {
    const double size = bodies_[body].radius;
    const double falling = std::sqrt(gravity_ * size);
    const double speed = std::max(trial_[body].velocity.norm(), falling > 0 ? falling : fastest_);
    const double sum = error.position.squaredNorm() / (size * size) + error.angle.squaredNorm() +
                       error.velocity.squaredNorm() / (speed * speed) +
                       error.spin.squaredNorm() * size * size / (speed * speed);
    return std::sqrt(sum / 12);
}

}  // namespace scree
