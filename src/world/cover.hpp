#pragma once

#include <span>
#include <vector>

#include <scree/detect/pair_search.hpp>
#include <scree/dynamics/step_problem.hpp>

#include "bodies.hpp"

namespace scree {

/// The region about each body within which the candidate pairs are complete.
class Cover {
  public:
    /// Lays it about the present poses: for the motion in the `left` seconds from `now` [s] to the tick's
    /// end, but for a fast body that forces move only for a few steps of `step` [s].
    void lay(const System& system, std::span<const WorldBody> bodies, double now, double left, double step);

    /// What the pair search is to use.
    [[nodiscard]] std::span<const SearchBody> bodies() const { return searched_; }

    /// Whether all bodies are expected to stay inside in the next step.
    [[nodiscard]] bool lasts(const System& system, double left, double step) const;

    /// Whether all trial poses are inside. A body for which that is not so gets more room when the cover is
    /// laid anew.
    bool holds(std::span<const TrialBody> trial);

  private:
    std::vector<SearchBody> searched_;
    std::vector<double> demand_;  ///< [m], the least reach that a body is to be given next time
};

}  // namespace scree
