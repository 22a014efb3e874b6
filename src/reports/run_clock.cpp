#include "run_clock.hpp"

#include <time.h>

#include <algorithm>

namespace scree {

namespace {

constexpr double told = 0.1;  // [s], from which on the processor time is good to some percent

double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

void RunClock::start() {
    part_processor_ = processor_time();
    part_ = std::chrono::steady_clock::now();
}

void RunClock::stop() {
    clock_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - part_).count();
    processor_ += processor_time() - part_processor_;
}

double RunClock::seconds() const {
    return processor_ > told ? std::min(clock_, processor_) : clock_;
}

}  // namespace scree
