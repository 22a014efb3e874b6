#include <scree/mesh/surface.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace scree {

namespace {

/// A side of a triangle. Those of one edge are neighbours in a sorted list.
struct Side {
    int low = 0;  // the edge's vertices
    int high = 0;
    int triangle = 0;
    bool rising = false;  // runs from low to high

    [[nodiscard]] bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const int from = mesh.triangles[t][i];
            const int to = mesh.triangles[t][(i + 1) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), from < to});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return sides;
}

/// Calls visit(first, last) for the sides of each edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, const Visit& visit) {
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].same_edge(sides[i])) {
            ++end;
        }
        visit(i, end);
        i = end;
    }
}

/// Every edge is run along as often one way as the other: no open edge, and neighbours agree.
bool is_balanced(const TriangleMesh& mesh) {
    const std::vector<Side> sides = sorted_sides(mesh);
    bool balanced = !sides.empty();
    for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
        int sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
            sum += sides[i].rising ? 1 : -1;
        }
        balanced = balanced && sum == 0;
    });
    return balanced;
}

void turn(TriangleMesh& mesh, int triangle) {
    std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
}

/// Six times the volume between some triangles and the mesh's first vertex.
double signed_volume(const TriangleMesh& mesh, const std::vector<int>& triangles) {
    const Vec3& apex = mesh.vertices.front();
    double sum = 0;
    for (const int t : triangles) {
        const auto& [a, b, c] = mesh.triangles[t];
        sum += (mesh.vertices[a] - apex).dot((mesh.vertices[b] - apex).cross(mesh.vertices[c] - apex));
    }
    return sum;
}

/// A triangle's neighbour across an edge that no third triangle shares.
struct Neighbour {
    int triangle = 0;
    bool agrees = false;
};

std::vector<std::vector<Neighbour>> neighbours_of(const TriangleMesh& mesh) {
    std::vector<std::vector<Neighbour>> neighbours(mesh.triangles.size());
    const std::vector<Side> sides = sorted_sides(mesh);
    for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
        if (end - begin == 2) {
            const Side& a = sides[begin];
            const Side& b = sides[begin + 1];
            neighbours[a.triangle].push_back({b.triangle, a.rising != b.rising});
            neighbours[b.triangle].push_back({a.triangle, a.rising != b.rising});
        }
    });
    return neighbours;
}

/// Turns triangles until neighbours agree, and each connected part so that its volume is positive.
void make_agree(TriangleMesh& mesh) {
    const auto neighbours = neighbours_of(mesh);
    enum class Sense : char { unknown, kept, turned };
    std::vector<Sense> sense(mesh.triangles.size(), Sense::unknown);
    for (std::size_t seed = 0; seed < sense.size(); ++seed) {
        if (sense[seed] != Sense::unknown) {
            continue;
        }
        std::vector<int> part{static_cast<int>(seed)};
        sense[seed] = Sense::kept;
        for (std::size_t i = 0; i < part.size(); ++i) {
            for (const auto& [next, agrees] : neighbours[part[i]]) {
                if (sense[next] == Sense::unknown) {
                    sense[next] = (sense[part[i]] == Sense::kept) == agrees ? Sense::kept : Sense::turned;
                    part.push_back(next);
                }
            }
        }
        for (const int t : part) {
            if (sense[t] == Sense::turned) {
                turn(mesh, t);
            }
        }
        if (signed_volume(mesh, part) < 0) {
            for (const int t : part) {
                turn(mesh, t);
            }
        }
    }
}

}  // namespace

Surface oriented_surface(const TriangleMesh& mesh) {
    Surface surface;
    surface.mesh.vertices = mesh.vertices;
    std::vector<int> all;
    for (const auto& [a, b, c] : mesh.triangles) {
        if (a != b && b != c && c != a) {
            all.push_back(static_cast<int>(all.size()));
            surface.mesh.triangles.push_back({a, b, c});
        }
    }
    if (!is_balanced(surface.mesh)) {
        const auto before = surface.mesh.triangles;
        make_agree(surface.mesh);
        surface.flipped = surface.mesh.triangles != before;
    }
    if (all.empty() || !is_balanced(surface.mesh)) {
        return surface;
    }
    if (signed_volume(surface.mesh, all) < 0) {
        for (const int t : all) {
            turn(surface.mesh, t);
        }
        surface.flipped = true;
    }
    surface.closed = signed_volume(surface.mesh, all) > 0;
    return surface;
}

}  // namespace scree
