#pragma once

namespace scree::test {

/// Counts the heap allocations of all threads while it lives: operator new, and malloc as Eigen calls it.
class AllocationCount {
  public:
    AllocationCount();
    /// Allocations since construction.
    [[nodiscard]] long count() const;

  private:
    long start_;
};

}  // namespace scree::test
