#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <scree/mesh/mass_properties.hpp>
#include <scree/overlap/convex_cells.hpp>
#include <scree/overlap/union_volume.hpp>

#include <tests/support/random.hpp>
#include <tests/support/solids.hpp>

using namespace scree;
using namespace scree::test;

namespace {

TriangleMesh turned_mesh(const TriangleMesh& mesh, const Pose& pose) {
    TriangleMesh other = mesh;
    for (Vec3& vertex : other.vertices) {
        vertex = pose * vertex;
    }
    return other;
}

// A prism of height 1 over a star of so many points, about the z axis.
TriangleMesh star(int points, double inner) {
    TriangleMesh mesh;
    const int corners = 2 * points;
    for (int level = 0; level < 2; ++level) {
        for (int i = 0; i < corners; ++i) {
            const double angle = std::numbers::pi * i / points;
            const double radius = i % 2 == 0 ? 1 : inner;
            mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), level);
        }
        mesh.vertices.emplace_back(0, 0, level);
    }
    for (int i = 0; i < corners; ++i) {
        const int next = (i + 1) % corners;
        const int above = i + corners + 1;
        const int above_next = next + corners + 1;
        mesh.triangles.push_back({corners, next, i});
        mesh.triangles.push_back({2 * corners + 1, above, above_next});
        mesh.triangles.push_back({i, next, above_next});
        mesh.triangles.push_back({i, above_next, above});
    }
    return mesh;
}

double sum_of_volumes(const std::vector<ConvexPolyhedron>& cells) {
    double sum = 0;
    for (const ConvexPolyhedron& cell : cells) {
        sum += mass_properties(cell).volume;
    }
    return sum;
}

}  // namespace

TEST_CASE("A mesh is cut into convex cells that fill it and share nothing, however it lies", "[overlap]") {
    Random random(461);
    for (const int points : {4, 5, 8}) {
        for (int i = 0; i < 5; ++i) {
            const TriangleMesh mesh = turned_mesh(star(points, 0.5), {random.vector(), random.rotation()});
            const std::vector<ConvexPolyhedron> cells = convex_cells(mesh, 100);
            CAPTURE(points, cells.size());
            CHECK(cells.size() >= static_cast<std::size_t>(points) - 1);
            const double volume = mass_properties(mesh).volume;
            CHECK(sum_of_volumes(cells) == Approx(volume).epsilon(1e-9));
            CHECK(union_volume(cells) == Approx(volume).epsilon(1e-9));
        }
    }
}

TEST_CASE("A convex mesh is one cell, and one that takes too many is none", "[overlap]") {
    const ConvexPolyhedron box = make_box({1, 2, 3});
    TriangleMesh mesh;
    mesh.vertices = box.vertices;
    for (const std::vector<int>& loop : loops(box)) {
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            mesh.triangles.push_back({loop[0], loop[i], loop[i + 1]});
        }
    }
    CHECK(convex_cells(mesh, 10).size() == 1);
    CHECK(convex_cells(star(12, 0.3), 5).empty());
}
