#include "convex_parts.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include <scree/overlap/convex_cells.hpp>
#include <scree/overlap/union_volume.hpp>

#include "decomposition.hpp"

namespace scree {

namespace {

constexpr double most_error = 0.01;  // of the mesh's volume
constexpr std::size_t most_parts = 256;

void require_closed(const MeshDescription& mesh) {
    if (!mesh.closed) {
        throw std::invalid_argument("the mesh is not closed, expected a closed one to measure its parts by");
    }
}

bool fills(double ratio) {
    return std::abs(ratio - 1) <= most_error;
}

[[noreturn]] void refuse(const char* what, double ratio) {
    std::ostringstream text;
    text << what << " fill " << ratio << " of the mesh, expected 0.99 to 1.01";
    throw std::invalid_argument(text.str());
}

// Pieces without volume are dropped.
std::vector<ConvexPolyhedron> hulls_of(const std::vector<std::vector<Vec3>>& pieces) {
    std::vector<ConvexPolyhedron> solids;
    for (const std::vector<Vec3>& points : pieces) {
        try {
            solids.push_back(convex_hull(points).solid);
        } catch (const std::invalid_argument&) {
        }
    }
    return solids;
}

}  // namespace

ConvexParts parts_from_files(const MeshShape& shape, const MeshDescription& mesh,
                             const std::filesystem::path& folder) {
    require_closed(mesh);
    ConvexParts parts;
    for (const std::filesystem::path& file : shape.part_files) {
        parts.solids.push_back(describe_mesh(folder / file, shape.scale).hull.solid);
    }
    parts.volume_ratio = union_volume(parts.solids) / mesh.mass.volume;
    if (!fills(parts.volume_ratio)) {
        refuse("the parts", parts.volume_ratio);
    }
    return parts;
}

ConvexParts decomposed(const MeshDescription& mesh) {
    require_closed(mesh);
    double best = 0;
    const auto good = [&](ConvexParts& parts) {
        if (parts.solids.empty() || parts.solids.size() > most_parts) {
            return false;
        }
        parts.volume_ratio = union_volume(parts.solids) / mesh.mass.volume;
        best = std::abs(parts.volume_ratio - 1) < std::abs(best - 1) ? parts.volume_ratio : best;
        return fills(parts.volume_ratio);
    };
    for (const DecompositionSetting& setting : decomposition_settings()) {
        ConvexParts parts{hulls_of(decompose(mesh.surface.mesh, setting))};
        if (good(parts)) {
            return parts;
        }
    }
    if (ConvexParts cells{convex_cells(mesh.surface.mesh, most_parts)}; good(cells)) {
        return cells;
    }
    refuse("the parts of the best of several decompositions", best);
}

}  // namespace scree
