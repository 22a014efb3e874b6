#pragma once

#include <scree/world/step_report.hpp>

namespace scree {

/// Keeps a report's sums going when one integrator takes over from another.
class Accounts {
  public:
    /// The report so far is that of integrators of the past.
    void close(const StepReport& report);
    /// Adds the present integrator's.
    void fill(const Integrator& integrator, StepReport& report) const;

  private:
    SteppingStatistics steps_;
    NewtonStatistics newton_;
    EnergyLedger energy_;
    Vec3 momentum_residual_ = Vec3::Zero();
    std::size_t evaluations_ = 0;
};

/// Contacts that touch, and the deepest of them.
void report_contacts(const System& system, std::span<const ContactResult> results, StepReport& report);

/// For an integrator that has just given up a step; `before` is what it had counted before that.
std::string why_no_step(const Integrator& integrator, const SteppingStatistics& before);

}  // namespace scree
