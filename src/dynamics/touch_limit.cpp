#include <scree/dynamics/touch_limit.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scree/overlap/separation.hpp>

namespace scree {

namespace {

constexpr double deepest = 0.05;        // of the thinner body's width, at the end of the step that touches
constexpr double least_periods = 0.05;  // of the contact's own period, that a step may always have
constexpr double least_widths = 0.5;    // that it may move by at most, even so

struct Mover {
    Pose shape;
    Vec3 centre;  // of the body [m]
    Vec3 velocity;
    double turning;  // [rad/s]
    double reach;    // of the shape about the body's centre [m]

    // The speed [m/s] at most, about the centre, of those points that the other can meet.
    [[nodiscard]] double rim(const Mover& other) const {
        const double met = std::min(reach, (centre - other.centre).norm() + other.reach);
        return turning > 0 ? turning * met : 0;
    }
};

Mover mover(const System& system, const Collider& collider) {
    const Body& body = system.bodies[static_cast<std::size_t>(collider.body)];
    const BodyState& state = system.states[static_cast<std::size_t>(collider.body)];
    return {Pose{state.position, state.orientation} * collider.local, state.position, velocity(body, state),
            spin(body, state).norm(), collider.local.position.norm() + bounding_radius(*collider.shape)};
}

double period(const PairConstants& pair) {
    const double stiffness = pair.elastic * pair.length * pair.length;
    return 2 * std::numbers::pi * std::sqrt(pair.reduced_mass / stiffness);
}

double limit(const System& system, const Contact& contact, double step) {
    const Mover a = mover(system, contact.a);
    const Mover b = mover(system, contact.b);
    const Vec3 relative = a.velocity - b.velocity;
    const double thinner = std::min(width(*contact.a.shape), width(*contact.b.shape));
    const double slack = deepest * thinner;
    const double rims = a.rim(b) + b.rim(a);
    if ((relative.norm() + rims) * step <= slack) {
        return step;
    }
    const Separation apart = separation(*contact.a.shape, a.shape, *contact.b.shape, b.shape);
    const double along = apart.gap > 0 ? -relative.dot(apart.axis) : relative.norm();
    const double closing = along + rims;
    if (closing * step <= std::max(apart.gap, 0.0) + slack) {
        return step;
    }
    const double wanted = (std::max(apart.gap, 0.0) + slack) / closing;
    const double least = std::min(least_periods * period(contact.pair), least_widths * thinner / closing);
    return std::min(step, std::max(wanted, least));
}

}  // namespace

double touch_limit(const System& system, double step) {
    for (const Contact& contact : system.contacts) {
        if (contact.history.age == 0) {
            step = limit(system, contact, step);
        }
    }
    return step;
}

}  // namespace scree
