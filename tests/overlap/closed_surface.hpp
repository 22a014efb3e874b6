#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <scree/overlap/clip.hpp>

namespace scree::test {

/// What is wrong with the surface of a clipped solid; empty when it is closed: every directed edge has its
/// reverse once, in the face that `across` names, and the live vertices are those of the faces.
inline std::string surface_fault(const ClippedSolid& solid) {
    struct Edge {
        int from, to, tag, across;
    };
    static thread_local std::vector<Edge> edges;
    static thread_local std::vector<int> used;
    edges.clear();
    used.clear();
    for (const ClippedSolid::Face& face : solid.faces()) {
        if (face.end - face.begin < 3) {
            return "a face of fewer than three edges";
        }
        for (int e = face.begin; e < face.end; ++e) {
            const HalfEdge& edge = solid.half_edges()[static_cast<std::size_t>(e)];
            const int next = e + 1 < face.end ? e + 1 : face.begin;
            edges.push_back({edge.vertex, solid.half_edges()[static_cast<std::size_t>(next)].vertex, face.tag,
                             edge.across});
            used.push_back(edge.vertex);
        }
    }
    const auto before = [](const Edge& a, const Edge& b) {
        return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    };
    std::sort(edges.begin(), edges.end(), before);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge& edge = edges[i];
        if (edge.from == edge.to) {
            return "an edge from a vertex to itself";
        }
        if (i > 0 && !before(edges[i - 1], edge)) {
            return "an edge twice in one direction";
        }
        const Edge sought{edge.to, edge.from, 0, 0};
        const auto reverse = std::lower_bound(edges.begin(), edges.end(), sought, before);
        if (reverse == edges.end() || before(sought, *reverse)) {
            return "an edge without its reverse";
        }
        if (reverse->tag != edge.across || reverse->across != edge.tag) {
            return "an edge with the wrong face across";
        }
    }
    std::vector<int> live = solid.vertices();
    std::sort(live.begin(), live.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    return live == used ? "" : "live vertices that are not those of the faces";
}

}  // namespace scree::test
