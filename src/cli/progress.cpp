#include "progress.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace scree {

namespace {

constexpr std::chrono::milliseconds pause{200};  // between two drawings
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

/// What the ledger leaves unexplained, over the energy that the run has moved.
double relative_residual(const EnergyLedger& energy) {
    const double moved = std::abs(energy.kinetic) + std::abs(energy.gravity) + std::abs(energy.work_applied) +
                         std::abs(energy.lost_normal_damping) + std::abs(energy.lost_friction);
    return moved > 0 ? energy.residual / moved : 0;
}

}  // namespace

Progress::Progress(const Simulation& simulation, double end, bool quiet)
    : simulation_(simulation), end_(end), begin_(simulation.time()) {
    if (!quiet && isatty(STDERR_FILENO) == 1) {
        line_ = line();
        drawer_ = std::thread([this] { draw(); });
    }
}

Progress::~Progress() {
    if (drawer_.joinable()) {
        {
            const std::scoped_lock lock(mutex_);
            over_ = true;
        }
        ended_.notify_one();
        drawer_.join();
        std::fputs(clear_line, stderr);
    }
}

void Progress::show() {
    if (drawer_.joinable()) {
        std::string now = line();
        const std::scoped_lock lock(mutex_);
        line_ = std::move(now);
    }
}

std::string Progress::line() {
    const StepReport& report = simulation_.report();
    if (const auto steps = static_cast<double>(report.steps.accepted - before_.accepted); steps > 0) {
        step_ = (report.steps.time_stepped - before_.time_stepped) / steps;
        order_ = usual_order(before_, report.steps);
        before_ = report.steps;
    }
    char text[200];
    std::snprintf(
        text, sizeof text,
        "%s  %.4g of %.4g s  step %.2g s  order %zu  contacts %zu  energy residual %.1e  %.0f s left",
        simulation_.scene().name.substr(0, 40).c_str(), simulation_.time(), end_, step_, order_,
        report.contacts, relative_residual(report.energy), remaining());
    return text;
}

/// Wall time [s], if the rest goes as fast as what is done.
double Progress::remaining() const {
    const double spent = std::chrono::duration<double>(Clock::now() - start_).count();
    const double done = simulation_.time() - begin_;
    return done > 0 ? spent * (end_ - simulation_.time()) / done : 0;
}

void Progress::draw() {
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, pause, [this] { return over_; })) {
        const double spent = std::chrono::duration<double>(Clock::now() - start_).count();
        std::fprintf(stderr, "%s%s  [%.0f s]", clear_line, line_.c_str(), spent);
        std::fflush(stderr);
    }
}

}  // namespace scree
