#include "cover.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace scree {

namespace {

constexpr double least_reach = 0.02;    // of ℓ, beyond the expected motion
constexpr double modest_reach = 0.2;    // of ℓ, for which the rest of the tick is always covered
constexpr double steps_covered = 4;     // at least, of a faster body
constexpr double steps_expected = 1.5;  // what the next step may be, over the last
constexpr double generosity = 2;        // over what a body that left its region asked for
constexpr double rounding = 1e-6;       // of the motion

// Bound on how far the points of a body that follows no path come in a time [s], contacts left aside.
class Motions {
  public:
    Motions(const Body& body, const BodyState& state, double radius) {
        const double turning = spin(body, state).norm();
        speed_ = velocity(body, state).norm() + (turning > 0 ? turning * radius : 0);
        acceleration_ = body.dynamic() ? (body.weight + body.force).norm() / body.mass : 0;
    }
    double operator()(double time) const {
        return time > 0 ? (speed_ + 0.5 * acceleration_ * time) * time : 0;
    }

  private:
    double speed_ = 0;
    double acceleration_ = 0;
};

// How far a body is expected to come [m]: of one that moves as prescribed, all that it will until the tick's
// end.
double expected_motion(const Body& body, const BodyState& state, double radius, double now, double left,
                       double step) {
    if (body.path != nullptr) {
        return body.path->reach(now, now + left, radius);
    }
    const Motions motion(body, state, radius);
    const double fast = body.dynamic() ? motion(steps_covered * step) : motion(left);
    return std::min(motion(left), std::max(modest_reach * body.radius, fast));
}

}  // namespace

void Cover::lay(const System& system, std::span<const WorldBody> bodies, double now, double left,
                double step) {
    demand_.resize(bodies.size(), 0);
    searched_.clear();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Body& body = system.bodies[b];
        const BodyState& state = system.states[b];
        const double expected = expected_motion(body, state, bodies[b].shape.radius, now, left, step);
        const double reach = std::max(least_reach * body.radius + (1 + rounding) * expected, demand_[b]);
        searched_.push_back(
            {bodies[b].object, &bodies[b].shape, {state.position, state.orientation}, reach, body.dynamic()});
        demand_[b] = 0;
    }
}

bool Cover::lasts(const System& system, double left, double step) const {
    for (std::size_t b = 0; b < searched_.size(); ++b) {
        if (system.bodies[b].path != nullptr) {
            continue;  // the cover was laid for all of its tick
        }
        const SearchBody& laid = searched_[b];
        const BodyState& state = system.states[b];
        const double radius = laid.shape->radius;
        const double moved = largest_move(laid.pose, {state.position, state.orientation}, radius);
        const Motions motion(system.bodies[b], state, radius);
        if (moved + std::min(motion(left), motion(steps_expected * step)) > laid.reach) {
            return false;
        }
    }
    return true;
}

bool Cover::holds(std::span<const TrialBody> trial) {
    bool all = true;
    for (std::size_t b = 0; b < searched_.size(); ++b) {
        const SearchBody& laid = searched_[b];
        const double moved = largest_move(laid.pose, trial[b].pose, laid.shape->radius);
        if (!(moved <= laid.reach)) {
            if (!std::isfinite(moved)) {
                throw std::runtime_error("a body's pose is not finite");
            }
            demand_[b] = generosity * moved;
            all = false;
        }
    }
    return all;
}

}  // namespace scree
