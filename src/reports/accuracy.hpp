#pragma once

#include <filesystem>

#include "case.hpp"
#include "reference.hpp"

namespace scree {

// Work against precision: every problem by every method.

/// error: against rigid bodies under Coulomb's law where that has an answer, else against the model;
/// numerical_error: against the model; model_error: of the model against rigid bodies.
/// status: done; wrong: the end is off by a body's size and more, or by all of a velocity; failed: the run
/// says so; stopped: it took too long; ended: it crashed or hung; not run: with a longer step it took too
/// long.
Table accuracy_table(const std::filesystem::path& folder);

/// The methods that a problem is stepped by. Within a family, the same but for step or tolerance, they go
/// from coarse to fine.
std::vector<MethodChoice> accuracy_methods(const Problem& problem, bool quick);

/// A case in a process of its own: a run to warm up, then the least time of several.
Row accuracy_row(const Problem& problem, const MethodChoice& method, const Reference& reference,
                 const Budget& budget);

/// Cases that are not in the tables of the folder.
std::vector<Case> accuracy_cases(const ReportRequest& request);

}  // namespace scree
