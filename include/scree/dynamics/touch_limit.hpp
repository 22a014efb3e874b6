#pragma once

#include <scree/dynamics/step_problem.hpp>

namespace scree {

/// The longest step [s], at most `step`, after which no two bodies that do not touch yet can have come deeper
/// into one another than a twentieth of the thinner one's width: (gap + 0.05 w)/closing speed, spin included.
/// It is never less than a twentieth of the stiffest period of the contact to come. And none in which two
/// bodies pass through more than half of the thinner one's width, so that a thin one is not left behind
/// unnoticed.
double touch_limit(const System& system, double step);

}  // namespace scree
