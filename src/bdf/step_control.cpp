// How large the next step is, and of which order.

#include <algorithm>
#include <cmath>

#include <scree/bdf/stepper.hpp>

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
constexpr double newton_shrink = 0.25;
constexpr std::size_t brisk = 6;  // iterations a step, above which it does not grow
constexpr std::size_t hard = 10;  // above which it shrinks, for the sake of the work per second
constexpr double easing = 0.7;
constexpr double smallest_share = 1e-9;   // of a tick, below which a step is not tried
constexpr std::size_t most_renewals = 4;  // of the candidate pairs, before the step is cut
constexpr std::size_t most_failures = 3;  // before order 1

double gain(double error, double with_bias, std::size_t order) {
    return 1 / (std::pow(with_bias * error, 1.0 / static_cast<double>(order + 1)) + 1e-6);
}

}  // namespace

// Never beyond the end, and never so close to it that a sliver is left.
double Stepper::choose_step(double end) const {
    const double left = end - time_;
    double step = step_;
    if (options_.fixed_step > 0 && failures_ == 0) {
        step = options_.fixed_step;
    } else {
        step = std::min(step, path_share * path_time_scale(system_));
    }
    if (!(step < left)) {
        return left;
    }
    const double parts = std::ceil(left / step * (1 - 1e-9));
    return options_.fixed_step > 0 || parts < 3 ? left / parts : step;
}

// Order and step of the next step, after one of `error` at order_.
void Stepper::plan_next(double time, double error) {
    if (options_.fixed_step > 0) {
        return;
    }
    const double step = time - time_;
    ++held_;
    double best = gain(error, bias, order_);
    std::size_t order = order_;
    if (held_ > order_ || order_ == 1) {
        if (order_ > 1) {
            const double down =
                gain(local_error(time, order_ - 1) / options_.tolerances.sum(), bias, order_ - 1);
            if (down > best) {
                best = down, order = order_ - 1;
            }
        }
        if (order_ < options_.max_order && history_.count() >= order_ + 2) {
            const double up =
                gain(local_error(time, order_ + 1) / options_.tolerances.sum(), bias_up, order_ + 1);
            if (up > best) {
                best = up, order = order_ + 1;
            }
        }
    }
    best = std::min({best, most_growth[order - 1], newton_.effort() > hard ? easing : best});
    if (newton_.effort() > brisk) {
        best = std::min(best, 1.0);
    }
    if (best < 1) {
        step_ = step * std::max(best, most_shrink);
    } else if (held_ > order_ && (best >= least_gain || order != order_)) {
        step_ = step * best;
        held_ = 0;
    } else {
        step_ = std::max(step_, step);  // it may have been cut short by the tick's end
        order = order_;
    }
    order_ = order;
}

// After a failed attempt. False: there is no smaller step to try.
bool Stepper::shrink(Attempt why, double step, double tick) {
    if (why == Attempt::not_covered) {
        ++statistics_.rejected_contact;
        newton_.forget();
        if (++renewals_ <= most_renewals) {
            return true;
        }
    }
    ++failures_;
    held_ = 0;
    if (why == Attempt::newton_failed) {
        ++statistics_.rejected_newton;
        step_ = step * newton_shrink;
    } else {
        ++statistics_.rejected_error;
        step_ = step * std::clamp(gain(error_, bias, order_), most_shrink, 0.9);
    }
    if (failures_ >= most_failures) {
        order_ = 1;
    }
    return step_ > smallest_share * tick;
}

}  // namespace scree
