#include "cover.hpp"

#include <algorithm>

namespace scree {

namespace {

constexpr double least_reach = 0.02;  // of ℓ, beyond the expected motion
constexpr double rounding = 1e-6;     // of the motion

// How far the body's points come [m], contacts left aside.
double expected_motion(const Body& body, const BodyState& state, double radius, double now, double duration) {
    if (body.path != nullptr) {
        return body.path->reach(now, now + duration, radius);
    }
    const double turning = spin(body, state).norm();
    const double speed = velocity(body, state).norm() + (turning > 0 ? turning * radius : 0);
    const double acceleration = body.dynamic() ? (body.weight + body.force).norm() / body.mass : 0;
    return (speed + 0.5 * acceleration * duration) * duration;
}

}  // namespace

void Cover::lay(const System& system, std::span<const WorldBody> bodies, double now, double duration) {
    searched_.clear();
    regions_.clear();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Body& body = system.bodies[b];
        const BodyState& state = system.states[b];
        const Pose pose{state.position, state.orientation};
        const double radius = bodies[b].shape.radius;
        const double expected = expected_motion(body, state, radius, now, duration);
        const double reach = least_reach * body.radius + (1 + rounding) * expected;
        const double skin = margins_ ? bodies[b].shape.skin : 0;
        searched_.push_back({bodies[b].object, &bodies[b].shape, pose, reach, body.dynamic(), skin});
        regions_.push_back({pose, radius, reach});
    }
}

void Cover::widen(std::span<const double> demand) {
    for (std::size_t b = 0; b < demand.size(); ++b) {
        regions_[b].reach = std::max(regions_[b].reach, demand[b]);
        searched_[b].reach = regions_[b].reach;
    }
}

}  // namespace scree
