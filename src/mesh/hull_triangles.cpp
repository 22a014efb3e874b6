#include "hull_triangles.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "directed_edges.hpp"

namespace scree {

namespace {

/// One run of Qhull, which owns memory of its own.
class Qhull {
  public:
    Qhull() { qh_zero(&state_, nullptr); }
    ~Qhull() {
        qh_freeqhull(&state_, !qh_ALL);
        int long_left = 0;
        int total_left = 0;
        qh_memfreeshort(&state_, &long_left, &total_left);
    }
    Qhull(const Qhull&) = delete;
    Qhull& operator=(const Qhull&) = delete;

    /// Qhull keeps the pointer to the coordinates.
    int run(std::vector<double>& coordinates, int turn, std::FILE* messages) {
        // Qt: facets that rounding made Qhull merge come back as triangles. QRn: turned by a rotation that n
        // seeds.
        std::string command = "qhull Qt Pp" + (turn == 0 ? "" : " QR" + std::to_string(turn));
        return qh_new_qhull(&state_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(), False,
                            command.data(), nullptr, messages);
    }

    [[nodiscard]] std::vector<Triangle> triangles() {
        std::vector<Triangle> found;
        for (const facetT* facet = state_.facet_list; facet != nullptr && facet->next != nullptr;
             facet = facet->next) {
            Triangle corners{};
            for (int i = 0; i < 3; ++i) {
                const auto* vertex = static_cast<const vertexT*>(facet->vertices->e[i].p);
                corners[i] = qh_pointid(&state_, vertex->point);
            }
            if (static_cast<bool>(facet->toporient) == static_cast<bool>(qh_ORIENTclock)) {
                std::swap(corners[1], corners[2]);
            }
            found.push_back(corners);
        }
        return found;
    }

  private:
    qhT state_{};
};

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Every edge has a triangle on both sides, and no triangle but slivers shows its back.
bool is_sound(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
    constexpr double sliver = 1e-9;
    DirectedEdges edges;
    Vec3 inside = Vec3::Zero();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            inside += points[triangles[t][i]] / static_cast<double>(3 * triangles.size());
            if (!edges.add(triangles[t][i], triangles[t][(i + 1) % 3], static_cast<int>(t))) {
                return false;
            }
        }
    }
    return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& corners) {
        const auto& [a, b, c] = corners;
        const Vec3 area = (points[b] - points[a]).cross(points[c] - points[a]);
        return edges.owner(b, a) >= 0 && edges.owner(c, b) >= 0 && edges.owner(a, c) >= 0 &&
               (area.norm() < sliver || area.dot(points[a] - inside) > 0);
    });
}

}  // namespace

std::vector<Triangle> hull_triangles(const std::vector<Vec3>& points, int turn) {
    std::vector<double> coordinates;
    coordinates.reserve(3 * points.size());
    for (const Vec3& p : points) {
        coordinates.insert(coordinates.end(), p.begin(), p.end());
    }
    // Qhull writes its complaints to a file.
    const std::unique_ptr<std::FILE, CloseFile> messages(std::fopen("/dev/null", "w"));
    Qhull hull;
    if (hull.run(coordinates, turn, messages.get()) != 0) {
        return {};
    }
    std::vector<Triangle> triangles = hull.triangles();
    return is_sound(points, triangles) ? triangles : std::vector<Triangle>{};
}

}  // namespace scree
