#include "meeting_plan.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double growth = 2;          // over the last time
constexpr double per_touching = 1.3;  // pairs of moving bodies that may be watched for one that touches
constexpr double per_body = 0.25;     // and for each body besides
constexpr double always = 8;          // few enough for any scene
constexpr double worth_it = 0.9;      // share of the pairs that half the time must not leave

// Whole steps, and no sliver at the end.
double in_steps(double span, double left, double fixed_step) {
    const double step = fixed_step > 0 ? left / std::ceil(left / fixed_step * (1 - 1e-9)) : span;
    const double taken = std::max(1.0, std::floor(span / step * (1 + 1e-9))) * step;
    return taken > left * (1 - 1e-9) ? left : taken;
}

// How many pairs of moving bodies the contacts are, and how many they may be.
struct Load {
    double pairs = 0;
    double limit = always;

    explicit Load(const System& system) {
        double touching = 0;
        for (const Contact& contact : system.contacts) {
            const bool both = system.bodies[static_cast<std::size_t>(contact.a.body)].dynamic() &&
                              system.bodies[static_cast<std::size_t>(contact.b.body)].dynamic();
            pairs += both ? 1 : 0;
            touching += both && contact.history.age > 0 ? 1 : 0;
        }
        const auto bodies = static_cast<double>(std::count_if(system.bodies.begin(), system.bodies.end(),
                                                              [](const Body& b) { return b.dynamic(); }));
        limit = std::max(limit, per_touching * touching + per_body * bodies);
    }
};

}  // namespace

double MeetingPlan::choose(double left, double fixed_step, const System& system,
                           const std::function<void(double)>& search) {
    double span = left;
    if (last_ > 0 && growth * last_ < left * (1 - 1e-9)) {
        const double parts = std::ceil(left / (growth * last_) * (1 - 1e-9));
        span = in_steps(left / parts, left, fixed_step);
    }
    search(span);
    Load load(system);
    while (load.pairs > load.limit) {
        const double half = in_steps(0.5 * span, span, fixed_step);
        if (half == span) {
            break;
        }
        search(half);
        const Load less(system);
        if (less.pairs > worth_it * load.pairs) {
            search(span);
            break;
        }
        span = half;
        load = less;
    }
    last_ = span;
    return span;
}

}  // namespace scree
