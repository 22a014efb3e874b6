#pragma once

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <scree/mesh/convex_hull.hpp>

/// A low random convex hull, size about 1, as an OBJ file that is gone with the object.
class RandomHull {
  public:
    explicit RandomHull(unsigned seed)
        : random_(seed),
          file_(std::filesystem::temp_directory_path() /
                ("scree_random_hull_" + std::to_string(seed) + ".obj")) {
        std::vector<scree::Vec3> points;
        while (points.size() < 24) {
            const scree::Vec3 point(2 * uniform() - 1, 2 * uniform() - 1, 2 * uniform() - 1);
            if (point.norm() < 1 && point.norm() > 0.1) {
                points.push_back(0.5 * point.normalized().cwiseProduct(scree::Vec3(1, 1, 0.5)));
            }
        }
        const scree::ConvexPolyhedron solid = scree::convex_hull(points).solid;
        std::ofstream out(file_);
        out.precision(17);
        for (const scree::Vec3& vertex : solid.vertices) {
            out << "v " << vertex.transpose() << '\n';
        }
        for (int f = 0; f < solid.face_count(); ++f) {
            out << 'f';
            for (int e = solid.face_begin[static_cast<std::size_t>(f)];
                 e < solid.face_begin[static_cast<std::size_t>(f) + 1]; ++e) {
                out << ' ' << solid.half_edges[static_cast<std::size_t>(e)].vertex + 1;
            }
            out << '\n';
        }
    }
    ~RandomHull() { std::filesystem::remove(file_); }
    RandomHull(const RandomHull&) = delete;
    RandomHull& operator=(const RandomHull&) = delete;

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// In [0, 1).
    [[nodiscard]] double uniform() const { return static_cast<double>(random_()) / 4294967296.0; }

  private:
    mutable std::mt19937 random_;
    std::filesystem::path file_;
};
