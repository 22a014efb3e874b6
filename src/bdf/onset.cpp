// Where a contact begins within a step.

#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/bdf/stepper.hpp>

namespace scree {

namespace {

constexpr std::size_t most_landings = 4;  // attempts to end a step there
constexpr double a_share = 0.1;           // of a step, that a moment may take
constexpr double a_moment = 1e-6;         // of the time that a body takes to move by its own radius

}  // namespace

// A step over the beginning of a contact whose force sets in with a jump has an error of first order. One
// that ends just there has not, and neither has one that begins there with the force as it is a moment later.
// Returns whether the next attempt is such a one.
bool Stepper::locate_onset(double time) {
    if (options_.fixed_step > 0 || ++landings_ > most_landings) {
        return false;
    }
    // Bodies that hardly move touch and part by rounding, and have no onset.
    if (moment() > a_share * (time - memory_.time)) {
        return false;
    }
    const double onset = onset_time(time);
    if (!(onset < time)) {
        return false;
    }
    ++statistics_.rejected_error;
    if (onset > memory_.time + moment()) {
        landing_ = onset;
    } else {
        landings_ = most_landings;
        start_afresh(memory_.time, 2 * moment());
    }
    return true;
}

// The earliest, by going back from the depth at the end of the step at the speed of approach.
double Stepper::onset_time(double time) const {
    double earliest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
        const Contact& contact = system_.contacts[i];
        const ContactResult& result = problem_.results()[i];
        if (contact.history.age > 0 || result.law.state == ContactState::open) {
            continue;
        }
        const auto velocity_of = [&](const Collider& collider) {
            const TrialBody& body = problem_.trial()[static_cast<std::size_t>(collider.body)];
            return Vec3(body.velocity + body.spin.cross(result.point - body.pose.position));
        };
        const double closing = (velocity_of(contact.b) - velocity_of(contact.a)).dot(result.normal);
        if (closing > 0) {
            earliest = std::min(earliest, time - result.depth / closing);
        }
    }
    return earliest;
}

// [s], too short to matter and long enough to be in contact.
double Stepper::moment() const {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < system_.bodies.size(); ++b) {
        const Body& body = system_.bodies[b];
        const double speed = velocity(body, system_.states[b]).norm();
        if (body.dynamic() && speed > 0) {
            shortest = std::min(shortest, body.radius / speed);
        }
    }
    return std::isfinite(shortest) ? a_moment * shortest : 0;
}

}  // namespace scree
