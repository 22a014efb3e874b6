#include <scree/scenes/output_times.hpp>

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double tolerance = 1e-12;

}  // namespace

// An end that is a multiple of `every` but for rounding is no tick of its own.
OutputTimes::OutputTimes(double every, double end)
    : every_(every),
      end_(end),
      last_(std::max<std::int64_t>(1, std::llround(std::ceil(end / every * (1 - tolerance))))) {}

double OutputTimes::at(std::int64_t i) const {
    return i >= last_ ? end_ : static_cast<double>(i) * every_;
}

std::int64_t OutputTimes::last_until(double time) const {
    const double limit = time * (1 + tolerance);
    if (limit >= end_) {
        return last_;
    }
    auto i = std::clamp<std::int64_t>(std::llround(std::floor(limit / every_)), 0, last_ - 1);
    while (i + 1 < last_ && at(i + 1) <= limit) {
        ++i;
    }
    while (i > 0 && at(i) > limit) {
        --i;
    }
    return i;
}

}  // namespace scree
