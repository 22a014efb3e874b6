#pragma once

#include <span>
#include <vector>

#include <scree/bdf/group.hpp>
#include <scree/detect/pair_search.hpp>

#include "bodies.hpp"

namespace scree {

/// The region about each body within which the candidate pairs are complete.
class Cover {
  public:
    /// Lays it about the present poses for the expected motion in the `duration` [s] from `now` [s] on.
    void lay(const System& system, std::span<const WorldBody> bodies, double now, double duration);

    /// Gives those bodies whose demand [m] is above 0 that much room.
    void widen(std::span<const double> demand);

    /// Whether Bullet's margins count as part of the bodies.
    void set_margins(bool counted) { margins_ = counted; }

    /// What the pair search is to use.
    [[nodiscard]] std::span<const SearchBody> bodies() const { return searched_; }
    /// What the groups are to keep to.
    [[nodiscard]] std::span<const BodyCover> regions() const { return regions_; }

  private:
    std::vector<SearchBody> searched_;
    std::vector<BodyCover> regions_;
    bool margins_ = false;
};

}  // namespace scree
