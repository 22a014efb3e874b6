#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace scree {

/// Why work in a process of its own gave no result.
class IsolationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What that process may use.
struct IsolationLimits {
    unsigned seconds = 0;                 ///< of processor time
    std::uintmax_t memory = 0;            ///< [bytes], beyond what this process has
    const char* worker = "the importer";  ///< what does the work, for the message
};

/// Runs `work` in a copy of this process and returns what it returns. Whatever it does to itself, crash, spin
/// or fill the memory, is an IsolationError here.
std::string run_isolated(const std::function<std::string()>& work, const IsolationLimits& limits);

}  // namespace scree
