#include "accounts.hpp"

#include <algorithm>
#include <sstream>

namespace scree {

void report_contacts(const System& system, std::span<const ContactResult> results, StepReport& report) {
    report.contacts = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (!results[i].touching) {
            continue;
        }
        ++report.contacts;
        for (const int number : {system.contacts[i].a.body, system.contacts[i].b.body}) {
            const Body& body = system.bodies[static_cast<std::size_t>(number)];
            if (body.dynamic()) {
                report.largest_overlap = std::max(report.largest_overlap, results[i].depth / body.radius);
            }
        }
    }
    report.most_contacts = std::max(report.most_contacts, report.contacts);
}

std::string why_no_step(const Group& group) {
    const SteppingStatistics& now = group.integrator().statistics();
    std::ostringstream why;
    why << "no step could be made at t = " << group.integrator().time()
        << " s: the equations were not solved in " << now.rejected_newton
        << " attempts and the error was too large in " << now.rejected_error
        << " since t = " << group.start().time << " s, down to the smallest step that is tried";
    return why.str();
}

}  // namespace scree
