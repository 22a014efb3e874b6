#pragma once

namespace scree {

/// From here on Ctrl-C asks the run to end after its tick; a second one ends the program at once.
void catch_interrupt();

[[nodiscard]] bool interrupted();

}  // namespace scree
