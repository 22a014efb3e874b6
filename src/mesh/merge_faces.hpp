#pragma once

#include <vector>

#include "hull_triangles.hpp"

namespace scree {

/// Faces as loops of vertex numbers, and which triangles each was made of.
struct MergedFaces {
    std::vector<std::vector<int>> loops;
    std::vector<std::vector<int>> triangles;
};

/// Joins neighbouring triangles whose vertices all lie within `tolerance` of a common plane, where the result
/// is a simple polygon, and takes out vertices that are left between two faces only. Triangles marked in
/// `keep` stay as they are.
MergedFaces merge_faces(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                        const std::vector<char>& keep, double tolerance);

}  // namespace scree
