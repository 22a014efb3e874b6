#include <scree/dynamics/touch_limit.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scree/overlap/separation.hpp>

namespace scree {

namespace {

constexpr double deepest = 0.05;        // of the thinner body's width, at the end of the step that touches
constexpr double least_periods = 0.05;  // of the contact's own period, that a step may always have
constexpr double most_widths = 0.5;     // by which bodies may move through each other in a step

struct Mover {
    Pose shape;
    Vec3 centre;  // of the body [m]
    Vec3 velocity;
    Vec3 spin;
    double reach;  // of the shape about the body's centre [m]

    // The speed [m/s] at most, about the centre, of those points that the other can meet: in any direction,
    // and along an axis.
    [[nodiscard]] double rim(const Mover& other) const { return speed(spin.norm(), other); }
    [[nodiscard]] double rim(const Mover& other, const Vec3& axis) const {
        return speed(spin.cross(axis).norm(), other);
    }

  private:
    [[nodiscard]] double speed(double turning, const Mover& other) const {
        const double met = std::min(reach, (centre - other.centre).norm() + other.reach);
        return turning > 0 ? turning * met : 0;
    }
};

Mover mover(const System& system, const Collider& collider) {
    const Body& body = system.bodies[static_cast<std::size_t>(collider.body)];
    const BodyState& state = system.states[static_cast<std::size_t>(collider.body)];
    return {Pose{state.position, state.orientation} * collider.local, state.position, velocity(body, state),
            spin(body, state), collider.local.position.norm() + bounding_radius(*collider.shape)};
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
    if ((relative.norm() + a.rim(b) + b.rim(a)) * step <= slack) {
        return step;
    }
    const Separation apart = separation(*contact.a.shape, a.shape, *contact.b.shape, b.shape);
    // Deep in each other they may pass through each other either way.
    const double axial = relative.dot(apart.axis);
    const double along = apart.gap < -slack ? std::abs(axial) : -axial;
    const double rims = a.rim(b, apart.axis) + b.rim(a, apart.axis);
    const bool parting = !(along + rims > 0);
    if (parting) {
        return step;
    }
    const double through = most_widths * thinner / (along + rims);
    if (contact.history.age > 0) {
        return std::min(step, through);
    }
    const double least = std::min(least_periods * period(contact.pair), through);
    const double free = std::max(apart.gap, 0.0);
    return std::min(step, std::max((free + slack) / (along + rims), least));
}

}  // namespace

double touch_limit(const System& system, double step) {
    for (const Contact& contact : system.contacts) {
        step = limit(system, contact, step);
    }
    return step;
}

}  // namespace scree
