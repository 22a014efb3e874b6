#include "decomposition.hpp"

#include <algorithm>
#include <map>
#include <utility>

#ifdef SCREE_HAS_HACD

#include <HACD/hacdHACD.h>

namespace scree {

namespace {

constexpr DecompositionSetting settings[] = {{1, 10, 0}, {1, 0.1, 0}, {8, 1, 0},  {16, 1, 0},
                                             {1, 1, 1},  {1, 0.1, 1}, {16, 1, 1}, {32, 1, 1}};

constexpr std::size_t most_triangles = 4000;  // the method's time grows with their square

TriangleMesh subdivided(const TriangleMesh& mesh) {
    TriangleMesh finer;
    finer.vertices = mesh.vertices;
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [found, added] =
            middles.try_emplace(std::minmax(a, b), static_cast<int>(finer.vertices.size()));
        if (added) {
            finer.vertices.emplace_back(0.5 * (mesh.vertices[static_cast<std::size_t>(a)] +
                                               mesh.vertices[static_cast<std::size_t>(b)]));
        }
        return found->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const int ab = middle(a, b);
        const int bc = middle(b, c);
        const int ca = middle(c, a);
        finer.triangles.insert(finer.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return finer;
}

/// Of a solution: the corners of the hull of each piece.
std::vector<std::vector<Vec3>> pieces_of(HACD::HACD& method) {
    std::vector<std::vector<Vec3>> pieces;
    for (std::size_t i = 0; i < method.GetNClusters(); ++i) {
        std::vector<HACD::Vec3<HACD::Real>> corners(method.GetNPointsCH(i));
        std::vector<HACD::Vec3<long>> faces(method.GetNTrianglesCH(i));
        method.GetCH(i, corners.data(), faces.data());
        std::vector<Vec3>& piece = pieces.emplace_back();
        for (const auto& corner : corners) {
            piece.emplace_back(corner.X(), corner.Y(), corner.Z());
        }
    }
    return pieces;
}

std::vector<std::vector<Vec3>> pieces_of(const TriangleMesh& mesh, const DecompositionSetting& setting) {
    std::vector<HACD::Vec3<HACD::Real>> points;
    for (const Vec3& v : mesh.vertices) {
        points.emplace_back(v.x(), v.y(), v.z());
    }
    std::vector<HACD::Vec3<long>> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
        triangles.emplace_back(a, b, c);
    }
    HACD::HACD method;
    method.SetPoints(points.data());
    method.SetNPoints(points.size());
    method.SetTriangles(triangles.data());
    method.SetNTriangles(triangles.size());
    method.SetScaleFactor(1000);  // of the diagonal
    method.SetCompacityWeight(1e-4);
    method.SetVolumeWeight(0);
    method.SetNClusters(setting.least_parts);
    method.SetNVerticesPerCH(1000);
    method.SetConcavity(setting.concavity);
    method.SetAddExtraDistPoints(true);
    method.SetAddNeighboursDistPoints(true);
    method.SetAddFacesPoints(true);
    method.Compute(true);
    method.DenormalizeData();
    return pieces_of(method);
}

}  // namespace

std::span<const DecompositionSetting> decomposition_settings() {
    return settings;
}

std::vector<std::vector<Vec3>> decompose(const TriangleMesh& mesh, const DecompositionSetting& setting) {
    TriangleMesh fine = mesh;
    for (std::size_t i = 0; i < setting.subdivisions && 4 * fine.triangles.size() <= most_triangles; ++i) {
        fine = subdivided(fine);
    }
    if (fine.triangles.size() > most_triangles) {
        return {};
    }
    return pieces_of(fine, setting);
}

}  // namespace scree

#else

namespace scree {

std::span<const DecompositionSetting> decomposition_settings() {
    return {};
}

std::vector<std::vector<Vec3>> decompose(const TriangleMesh& /*mesh*/,
                                         const DecompositionSetting& /*setting*/) {
    return {};
}

}  // namespace scree

#endif
