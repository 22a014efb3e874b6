#pragma once

#include <scree/overlap/overlap.hpp>

namespace scree {

/// Where two bodies meet, as a pure function of the poses of their shapes. A contact that carries one asks it
/// in place of the overlap of the two shapes.
class PairGeometry {
  public:
    virtual ~PairGeometry() = default;

    /// As overlap(): fills `geometry` by the conventions of ContactGeometry, or returns false and leaves it
    /// as it was when the two do not touch.
    virtual bool geometry(const Pose& pose_a, const Pose& pose_b, Detail detail, bool was_centre_line,
                          OverlapWorkspace& workspace, ContactGeometry& geometry) const = 0;

  protected:
    /// Made by those that derive from it.
    PairGeometry() = default;
    /// Copied by those that derive from it.
    PairGeometry(const PairGeometry&) = default;
    /// Likewise.
    PairGeometry& operator=(const PairGeometry&) = default;
};

}  // namespace scree
