#include "accounts.hpp"

#include <algorithm>
#include <sstream>

namespace scree {

void Accounts::close(const StepReport& report) {
    steps_ = report.steps;
    newton_ = report.newton;
    energy_ = report.energy;
    momentum_residual_ = report.momentum_residual;
    evaluations_ = report.contact_evaluations;
}

void Accounts::fill(const Integrator& integrator, StepReport& report) const {
    report.steps = steps_;
    report.newton = newton_;
    add(report.steps, integrator.statistics());
    add(report.newton, integrator.newton());
    report.contact_evaluations = evaluations_ + integrator.problem().evaluations();
    report.energy = integrator.energy();
    add_flows(report.energy, energy_);
    report.momentum_residual = momentum_residual_ + integrator.momentum_residual();
}

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

std::string why_no_step(const Integrator& integrator, const SteppingStatistics& before) {
    const SteppingStatistics& now = integrator.statistics();
    std::ostringstream why;
    why << "no step could be made at t = " << integrator.time()
        << " s: Newton's iteration did not converge in " << now.rejected_newton - before.rejected_newton
        << " attempts and the error was too large in " << now.rejected_error - before.rejected_error
        << ", down to the smallest step that is tried";
    return why.str();
}

}  // namespace scree
