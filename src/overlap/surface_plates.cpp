#include <scree/overlap/surface_plates.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <scree/mesh/convex_hull.hpp>
#include <scree/overlap/clip.hpp>

namespace scree {

namespace {

constexpr double flat = 1e-9;         // of a length, or a sine, that counts as nothing
constexpr double least_mitre = 1e-3;  // below which the faces at an edge fold back on one another
constexpr double inwards = 1e-3;      // of the way from a corner to the middle, where thickness is measured

using Loop = std::vector<int>;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Flat convex faces over shared vertices.
class Faces {
  public:
    explicit Faces(const TriangleMesh& surface) : vertices_(surface.vertices) {
        for (const auto& [a, b, c] : surface.triangles) {
            const Vec3 area = (point(b) - point(a)).cross(point(c) - point(a));
            if (area.norm() > flat * (point(b) - point(a)).squaredNorm()) {
                loops_.push_back({a, b, c});
                normals_.push_back(area.normalized());
            }
        }
        find_edges();
        while (merge_any()) {
        }
    }

    [[nodiscard]] std::size_t count() const { return loops_.size(); }
    [[nodiscard]] const Loop& loop(std::size_t face) const { return loops_[face]; }
    [[nodiscard]] const Vec3& normal(std::size_t face) const { return normals_[face]; }
    [[nodiscard]] const Vec3& point(int vertex) const { return vertices_[at(vertex)]; }
    /// The face on the other side of an edge; negative: none.
    [[nodiscard]] int across(int start, int end) const {
        const auto found = edges_.find({end, start});
        return found == edges_.end() ? -1 : found->second;
    }
    [[nodiscard]] Vec3 middle(std::size_t face) const {
        Vec3 sum = Vec3::Zero();
        for (const int vertex : loops_[face]) {
            sum += point(vertex);
        }
        return sum / static_cast<double>(loops_[face].size());
    }

  private:
    void find_edges() {
        edges_.clear();
        for (std::size_t face = 0; face < loops_.size(); ++face) {
            const Loop& loop = loops_[face];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                edges_[{loop[i], loop[(i + 1) % loop.size()]}] = static_cast<int>(face);
            }
        }
    }

    // Joins two neighbours in one plane whose union is convex.
    bool merge_any() {
        for (const auto& [edge, number] : edges_) {
            const int other = across(edge.first, edge.second);
            if (other <= number || normals_[at(number)].cross(normals_[at(other)]).norm() > flat ||
                normals_[at(number)].dot(normals_[at(other)]) < 0) {
                continue;
            }
            const Loop joined = join(loops_[at(number)], loops_[at(other)], edge.first, edge.second);
            if (!joined.empty() && convex(joined, normals_[at(number)])) {
                loops_[at(number)] = joined;
                loops_.erase(loops_.begin() + other);
                normals_.erase(normals_.begin() + other);
                find_edges();
                return true;
            }
        }
        return false;
    }

    // Two loops without the edge that they share; empty when they share more than that.
    static Loop join(const Loop& one, const Loop& two, int start, int end) {
        Loop joined;
        const auto add = [&](const Loop& loop, int first, int last) {
            const auto begin = std::find(loop.begin(), loop.end(), first) - loop.begin();
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int vertex = loop[(static_cast<std::size_t>(begin) + i) % loop.size()];
                if (vertex == last) {
                    return;
                }
                joined.push_back(vertex);
            }
        };
        add(one, end, start);
        add(two, start, end);
        Loop sorted = joined;
        std::sort(sorted.begin(), sorted.end());
        const bool simple = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
        return simple ? joined : Loop();
    }

    [[nodiscard]] bool convex(const Loop& loop, const Vec3& normal) const {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec3 in = point(loop[(i + 1) % loop.size()]) - point(loop[i]);
            const Vec3 out = point(loop[(i + 2) % loop.size()]) - point(loop[(i + 1) % loop.size()]);
            if (in.cross(out).dot(normal) < -flat * in.norm() * out.norm()) {
                return false;
            }
        }
        return true;
    }

    const std::vector<Vec3>& vertices_;
    std::vector<Loop> loops_;
    std::vector<Vec3> normals_;
    std::map<std::pair<int, int>, int> edges_;  ///< face by directed edge
};

// How far [m] a ray goes from a point before it meets a triangle in front of it.
double reach(const TriangleMesh& surface, const Vec3& from, const Vec3& direction) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : surface.triangles) {
        const Vec3& corner = surface.vertices[at(a)];
        const Vec3 u = surface.vertices[at(b)] - corner;
        const Vec3 v = surface.vertices[at(c)] - corner;
        const Vec3 across = direction.cross(v);
        const double volume = u.dot(across);
        if (std::abs(volume) <= flat * u.norm() * v.norm()) {
            continue;
        }
        const Vec3 offset = from - corner;
        const double x = offset.dot(across) / volume;
        const Vec3 side = offset.cross(u);
        const double y = direction.dot(side) / volume;
        const double distance = v.dot(side) / volume;
        if (x >= 0 && y >= 0 && x + y <= 1 && distance > flat * u.norm()) {
            least = std::min(least, distance);
        }
    }
    return least;
}

double room_behind(const TriangleMesh& surface, const Faces& faces, std::size_t face, double thickness) {
    const Vec3 middle = faces.middle(face);
    double least = std::min(thickness, 0.5 * reach(surface, middle, -faces.normal(face)));
    for (const int vertex : faces.loop(face)) {
        const Vec3 from = faces.point(vertex) + inwards * (middle - faces.point(vertex));
        least = std::min(least, 0.5 * reach(surface, from, -faces.normal(face)));
    }
    return least;
}

// The plane through an edge that parts the two plates there; on a border that across the face.
Plane parting(const Faces& faces, std::size_t face, int start, int end) {
    const Vec3 along = (faces.point(end) - faces.point(start)).normalized();
    Vec3 out = along.cross(faces.normal(face));
    if (const int other = faces.across(start, end); other >= 0) {
        const Vec3 out_of_other = faces.normal(at(other)).cross(along);
        if (const Vec3 mitre = out - out_of_other; mitre.norm() > least_mitre) {
            out = mitre.normalized();
        }
    }
    return {out, out.dot(faces.point(start))};
}

}  // namespace

std::vector<ConvexPolyhedron> surface_plates(const TriangleMesh& surface, double thickness) {
    const Faces faces(surface);
    double size = thickness;
    for (const Vec3& vertex : surface.vertices) {
        size = std::max(size, vertex.cwiseAbs().maxCoeff());
    }
    std::vector<ConvexPolyhedron> plates;
    for (std::size_t face = 0; face < faces.count(); ++face) {
        const Vec3& normal = faces.normal(face);
        const double height = normal.dot(faces.middle(face));
        ClippedSolid plate;
        plate.start(make_box(Vec3::Constant(8 * size)));
        bool left = plate.cut({normal, height}, 0) &&
                    plate.cut({-normal, room_behind(surface, faces, face, thickness) - height}, 0);
        const Loop& loop = faces.loop(face);
        for (std::size_t i = 0; i < loop.size() && left; ++i) {
            left = plate.cut(parting(faces, face, loop[i], loop[(i + 1) % loop.size()]), 0);
        }
        if (!left) {
            continue;
        }
        std::vector<Vec3> corners;
        for (const int vertex : plate.vertices()) {
            corners.push_back(plate.point(vertex));
        }
        plates.push_back(convex_hull(corners).solid);
    }
    return plates;
}

}  // namespace scree
