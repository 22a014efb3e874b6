#include "progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace scree {

namespace {

constexpr std::chrono::milliseconds least_pause{100};
constexpr const char* clear_line = "\r\x1b[K";

/// The order that most of the steps between two counts had.
std::size_t usual_order(const SteppingStatistics& before, const SteppingStatistics& now) {
    std::size_t usual = 0;
    for (std::size_t i = 1; i < now.orders.size(); ++i) {
        if (now.orders[i] - before.orders[i] > now.orders[usual] - before.orders[usual]) {
            usual = i;
        }
    }
    return usual + 1;
}

}  // namespace

Progress::Progress(const Simulation& simulation, double end, bool quiet)
    : simulation_(simulation),
      end_(end),
      enabled_(!quiet && isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
    if (enabled_) {
        std::fputs(clear_line, stderr);
    }
}

void Progress::show() {
    const Clock::time_point now = Clock::now();
    if (!enabled_ || now - last_ < least_pause) {
        return;
    }
    last_ = now;
    const StepReport& report = simulation_.report();
    const double steps = static_cast<double>(report.steps.accepted - before_.accepted);
    const double step = steps > 0 ? (report.steps.time_stepped - before_.time_stepped) / steps : 0;
    std::fprintf(stderr, "%s%s  %.4g of %.4g s  step %.2g s  order %zu  contacts %zu  %.0f s left",
                 clear_line, simulation_.scene().name.c_str(), simulation_.time(), end_, step,
                 usual_order(before_, report.steps), report.contacts, remaining());
    std::fflush(stderr);
    before_ = report.steps;
}

/// Wall time [s], if the rest goes as fast as what is done.
double Progress::remaining() const {
    const double spent = std::chrono::duration<double>(last_ - start_).count();
    const double done = simulation_.time();
    return done > 0 ? spent * (end_ - done) / done : 0;
}

}  // namespace scree
