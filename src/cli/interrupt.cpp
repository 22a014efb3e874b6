#include "interrupt.hpp"

#include <csignal>

namespace scree {

namespace {

volatile std::sig_atomic_t asked = 0;

void ask(int /*signal*/) {
    asked = 1;
}

}  // namespace

void catch_interrupt() {
    struct sigaction action {};
    action.sa_handler = ask;
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    std::signal(SIGXFSZ, SIG_IGN);  // a file at its limit is an error like a full disk
}

bool interrupted() {
    return asked != 0;
}

}  // namespace scree
