#include <scree/mesh_io/isolated.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace scree {

namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool limit_memory = false;  // the sanitizer maps more than any machine has
#else
constexpr bool limit_memory = true;
#endif
constexpr int finished = 0;  // exit statuses of the copy
constexpr int threw = 1;     // an exception came out of the work
constexpr unsigned patience =
    20;  // times its limit in wall time: it may wait for the processor, not for ever

/// Closes a descriptor, or the end of a pipe, when done.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int get() const { return number_; }
    void close() {
        if (number_ >= 0) {
            ::close(number_);
        }
        number_ = -1;
    }

  private:
    int number_;
};

std::string reason_of(int error) {
    return std::generic_category().message(error);
}

rlim_t present_memory() {
    std::uintmax_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uintmax_t>(::sysconf(_SC_PAGESIZE));
}

void set_limit(int resource, rlim_t value) {
    const rlimit limit{value, value};
    ::setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

/// What the copy does before its work: no handlers of the program's, no messages, no more than it may use.
void settle_down(const IsolationLimits& limits) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGXCPU, SIGPIPE}) {
        std::signal(signal, SIG_DFL);
    }
    set_limit(RLIMIT_CORE, 0);
    set_limit(RLIMIT_CPU, limits.seconds);
    if (limit_memory) {
        set_limit(RLIMIT_AS, present_memory() + limits.memory);
        const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        ::dup2(nowhere, STDERR_FILENO);
    }
}

bool write_all(int descriptor, const std::string& bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t written = ::write(descriptor, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno != EINTR) {
            return false;
        }
        done += written < 0 ? 0 : static_cast<std::size_t>(written);
    }
    return true;
}

[[noreturn]] void work_as_copy(const std::function<std::string()>& work, const IsolationLimits& limits,
                               int result) {
    settle_down(limits);
    int status = threw;
    try {
        status = write_all(result, work()) ? finished : threw;
    } catch (...) {
        // What it was matters to nobody: the work reports errors in its result.
    }
    ::_exit(status);  // nothing of the program's own is to run at its exit
}

/// All that comes until the other end is closed. Returns false when it takes too long.
bool read_all(int descriptor, std::chrono::seconds longest, std::string& bytes) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end = Clock::now() + longest;
    std::string block(1 << 16, '\0');
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd waiting{descriptor, POLLIN, 0};
        const int ready = left > 0 ? ::poll(&waiting, 1, static_cast<int>(std::min<long>(left, 60'000))) : 0;
        if (left <= 0) {
            return false;
        }
        const ssize_t got = ready > 0 ? ::read(descriptor, block.data(), block.size()) : -1;
        if (got == 0) {
            return true;
        }
        if (got > 0) {
            bytes.append(block, 0, static_cast<std::size_t>(got));
        }
    }
}

/// The end of the copy in words; empty when it came to its own.
std::string wait_for(pid_t copy, const std::string& worker) {
    int status = 0;
    while (::waitpid(copy, &status, 0) < 0) {
        if (errno != EINTR) {
            return "";  // the program lets the system take care of its children: the result decides
        }
    }
    if (WIFSIGNALED(status)) {
        return WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL ? "it takes too long"
                                                                          : worker + " crashes on it";
    }
    return WEXITSTATUS(status) == finished ? "" : worker + " fails on it";
}

}  // namespace

std::string run_isolated(const std::function<std::string()>& work, const IsolationLimits& limits) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) {
        throw IsolationError("no pipe: " + reason_of(errno));
    }
    const Descriptor reading(ends[0]);
    Descriptor writing(ends[1]);
    const pid_t copy = ::fork();
    if (copy < 0) {
        throw IsolationError("no process: " + reason_of(errno));
    }
    if (copy == 0) {
        work_as_copy(work, limits, writing.get());
    }
    writing.close();
    std::string result;
    const bool in_time = read_all(reading.get(), std::chrono::seconds(patience) * limits.seconds, result);
    if (!in_time) {
        ::kill(copy, SIGKILL);
    }
    if (const std::string failure = wait_for(copy, limits.worker); !failure.empty()) {
        throw IsolationError(failure);
    }
    return result;
}

}  // namespace scree
