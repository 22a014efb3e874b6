// How large the next step is, and of which order.

#include <algorithm>
#include <cmath>

#include <scree/bdf/stepper.hpp>
#include <scree/dynamics/touch_limit.hpp>

namespace scree {

namespace {

// Those of CVODE: bias on the error of the present and the lower order, and of the higher one; least gain.
constexpr double bias = 6;
constexpr double bias_up = 10;
constexpr double least_gain = 1.5;
constexpr std::array<double, highest_order> most_growth{10, 2, 1.4, 1.4,
                                                        1.4};  // keeps the formula zero-stable
constexpr double most_shrink = 0.2;
constexpr double path_share = 0.5;  // of the time scale of a prescribed path: a dozen steps a period
constexpr double solver_shrink = 0.5;
constexpr std::size_t brisk = 6;  // iterations a step, above which it does not grow
constexpr std::size_t hard = 10;  // above which it shrinks, for the sake of the work per second
constexpr double easing = 0.7;
constexpr double smallest_share = 1e-12;   // of a tick, below which a step is not tried
constexpr double even = 0.3;               // ratio of differences two orders apart that is suspect
constexpr std::size_t most_suspect = 5;    // successive steps, before the order is left
constexpr std::size_t steps_barred = 100;  // from coming back

double gain(double error, double with_bias, std::size_t order) {
    return 1 / (std::pow(with_bias * error, 1.0 / static_cast<double>(order + 1)) + 1e-6);
}

}  // namespace

// Never beyond the end, and never so close to it that a sliver is left.
double Stepper::choose_step(double end) const {
    const double left = end - memory_.time;
    double step = memory_.next_step;
    if (options_.fixed_step == 0) {
        step = std::min({step, left, path_share * path_time_scale(system_)});
    }
    step = touch_limit(system_, step);
    if (!(step < left)) {
        return left;
    }
    const double parts = std::ceil(left / step * (1 - 1e-9));
    return options_.fixed_step > 0 || parts < 3 ? left / parts : step;
}

// Order and step of the next step, after one of `error` at the present order.
void Stepper::plan_next(double time, double error) {
    const double step = time - memory_.time;
    if (options_.fixed_step > 0) {  // back to it, where a failure has cut it
        memory_.next_step = std::min(options_.fixed_step, std::max(memory_.next_step, step) * most_growth[1]);
        return;
    }
    const std::size_t present = memory_.order;
    ++memory_.held;
    memory_.barred -= memory_.barred > 0 ? 1 : 0;
    double best = gain(error, bias, present);
    std::size_t order = present;
    const bool free_choice = memory_.held > present || present == 1;
    if (free_choice && present > 1) {
        const double down = gain(local_error(time, present - 1), bias, present - 1);
        if (down > best) {
            best = down, order = present - 1;
        }
    }
    const bool may_rise = present < options_.max_order && (present < 2 || memory_.barred == 0);
    if (free_choice && may_rise && memory_.past.count() >= present + 2) {
        const double up = gain(local_error(time, present + 1), bias_up, present + 1);
        if (up > best) {
            best = up, order = present + 1;
        }
    }
    best = std::min({best, most_growth[order - 1], corrector_.effort() > hard ? easing : best});
    if (corrector_.effort() > brisk) {
        best = std::min(best, 1.0);
    }
    if (best < 1) {
        memory_.next_step = step * std::max(best, most_shrink);
    } else if (memory_.held > present && (best >= least_gain || order != present)) {
        memory_.next_step = step * best;
        memory_.held = 0;
    } else {
        memory_.next_step = std::max(memory_.next_step, step);  // it may have been cut by the tick's end
        order = present;
    }
    memory_.order = order;
    watch_stability(time);
}

// Above order 2 the formulas are unstable for oscillations of little damping, and the error test then only
// keeps the step at the limit. There the solution's differences do not fall from order to order any more, as
// they do where the step resolves it.
void Stepper::watch_stability(double time) {
    if (memory_.order < 3 || memory_.past.count() < memory_.order + 2) {
        memory_.suspect = 0;
        return;
    }
    const double high = largest_difference(time, memory_.order + 1);
    const double low = largest_difference(time, memory_.order - 1);
    memory_.suspect = high > even * low ? memory_.suspect + 1 : 0;
    if (memory_.suspect >= most_suspect) {
        --memory_.order;
        ++statistics_.unstable_orders;
        memory_.suspect = memory_.held = 0;
        memory_.barred = steps_barred;
    }
}

// After a failed attempt. False: there is no smaller step to try.
bool Stepper::shrink(Attempt why, double step, double tick) {
    ++failures_;
    memory_.held = 0;
    if (why == Attempt::not_solved) {
        ++statistics_.rejected_newton;
        memory_.next_step = step * solver_shrink;
    } else {
        ++statistics_.rejected_error;
        memory_.next_step = step * std::clamp(gain(error_, bias, memory_.order), most_shrink, 0.9);
    }
    if (failures_ >= most_failures) {
        memory_.order = 1;
    }
    return memory_.next_step > smallest_share * tick;
}

}  // namespace scree
