#include <unistd.h>

#include <chrono>
#include <cstdio>

#include <scree/reports/report.hpp>

#include "commands.hpp"
#include "interrupt.hpp"

namespace scree {

namespace {

using Clock = std::chrono::steady_clock;

/// One line on a terminal's standard error.
class ReportLine {
  public:
    explicit ReportLine(bool quiet) : enabled_(!quiet && isatty(STDERR_FILENO) == 1) {}

    void show(std::size_t done, std::size_t all, const std::string& next) const {
        if (enabled_) {
            std::fprintf(stderr, "\r\x1b[K%zu of %zu  %.0f s left  %.60s", done, all, remaining(done, all),
                         next.c_str());
            std::fflush(stderr);
        }
    }
    void clear() const {
        if (enabled_) {
            std::fputs("\r\x1b[K", stderr);
        }
    }

  private:
    /// Wall time [s], if the rest goes as fast as what is done.
    [[nodiscard]] double remaining(std::size_t done, std::size_t all) const {
        const double spent = std::chrono::duration<double>(Clock::now() - start_).count();
        return done > 0 ? spent * static_cast<double>(all - done) / static_cast<double>(done) : 0;
    }

    bool enabled_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace

int report_command(const ReportOrder& order) {
    ReportRequest request;
    const bool all = order.part == "all";
    request.accuracy = all || order.part == "accuracy";
    request.stability = all || order.part == "stability";
    request.cost = all || order.part == "cost";
    request.quick = order.quick;
    request.out = order.out;
    request.only = order.only;
    catch_interrupt();
    const ReportLine line(order.quiet);
    const bool finished =
        make_report(request, [&](std::size_t done, std::size_t cases, const std::string& next) {
            line.show(done, cases, next);
            return !interrupted();
        });
    line.clear();
    if (!order.quiet) {
        std::printf("report: %s; see %s\n", finished ? "done" : "interrupted, to be gone on with",
                    (request.out / "index.html").c_str());
    }
    return finished ? exit_done : exit_interrupted;
}

}  // namespace scree
