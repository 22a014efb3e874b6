#pragma once

#include <functional>
#include <string>

#include "method.hpp"
#include "problem.hpp"
#include "table.hpp"

namespace scree {

/// How long a run may take [s].
struct Budget {
    double seconds = 10;  ///< of one run; looked at after every output time
    /// Processor time of all that one case does, after which it is ended from outside.
    [[nodiscard]] unsigned limit() const { return static_cast<unsigned>(3 * seconds + 5); }
};

/// A scene run once, and what was seen of it.
struct Observation {
    bool finished = false;
    std::string message;          ///< why not
    double reached = 0;           ///< [s]
    double seconds = 0;           ///< RunClock's, of the steps, without loading and looking
    std::vector<double> times;    ///< [s], of the samples
    std::vector<Values> samples;  ///< at every output time that was reached, or at the end
    StepReport report;
};

/// Runs a problem by a method. Does not throw: a scene that is refused is a message.
Observation observe_run(const Problem& problem, const MethodChoice& method, const Budget& budget);

/// Runs `work` in a process of its own and gives back its row of cells; instead of it `failed` for what took
/// too long or crashed, with the reason in words.
struct Isolated {
    bool done = false;
    Row row;
    std::string message;
};
Isolated isolated_row(const std::function<Row()>& work, const Budget& budget);

}  // namespace scree
