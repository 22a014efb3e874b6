#pragma once

#include <vector>

#include "directed_edges.hpp"
#include "hull_triangles.hpp"

namespace scree {

/// Finds the triangles of a closed surface that lie in one plane with a given one.
class CoplanarRegion {
  public:
    /// Keeps references to both.
    CoplanarRegion(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, double tolerance);

    /// The triangles that hang together with the seed and have all vertices within the tolerance of the plane
    /// that fits them best. Those marked `taken` are left alone.
    [[nodiscard]] std::vector<int> grown(int seed, const std::vector<char>& taken);

    /// The region's border as one simple loop of vertices; empty if it is not one.
    [[nodiscard]] std::vector<int> border(const std::vector<int>& region);

    [[nodiscard]] double area(int triangle) const { return area_[triangle].norm(); }

  private:
    struct FittedPlane;

    [[nodiscard]] FittedPlane fitted(const std::vector<int>& region, const Vec3& outward) const;
    [[nodiscard]] bool fits(int triangle, const FittedPlane& plane) const;
    [[nodiscard]] std::vector<int> connected(int seed, const FittedPlane& plane,
                                             const std::vector<char>& taken);

    const std::vector<Vec3>& points_;
    const std::vector<Triangle>& triangles_;
    double tolerance_;
    DirectedEdges edges_;
    std::vector<Vec3> area_;   // [m²], vectors
    std::vector<int> marked_;  // the mark that last reached each triangle
    int mark_ = 0;
};

}  // namespace scree
