#pragma once

#include <scree/bdf/group.hpp>
#include <scree/world/step_report.hpp>

namespace scree {

/// Contacts that touch, and the deepest of them.
void report_contacts(const System& system, std::span<const ContactResult> results, StepReport& report);

/// Why a group could not go on.
std::string why_no_step(const Group& group);

}  // namespace scree
