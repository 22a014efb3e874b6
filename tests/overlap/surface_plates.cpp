#include <algorithm>

#include <catch2/catch.hpp>
#include <scree/mesh/mass_properties.hpp>
#include <scree/overlap/overlap.hpp>
#include <scree/overlap/surface_plates.hpp>
#include <scree/overlap/union_volume.hpp>

#include <tests/support/solids.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// The box with these corners as twelve triangles; inward: seen from inside.
TriangleMesh box_surface(const Vec3& edges, bool inward) {
    const ConvexPolyhedron box = make_box(edges);
    TriangleMesh mesh;
    mesh.vertices = box.vertices;
    for (const std::vector<int>& loop : loops(box)) {
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            mesh.triangles.push_back({loop[0], loop[i], loop[i + 1]});
            if (inward) {
                std::swap(mesh.triangles.back()[1], mesh.triangles.back()[2]);
            }
        }
    }
    return mesh;
}

double sum_of_volumes(const std::vector<ConvexPolyhedron>& plates) {
    double sum = 0;
    for (const ConvexPolyhedron& plate : plates) {
        sum += mass_properties(plate).volume;
    }
    return sum;
}

}  // namespace

TEST_CASE("Plates behind a convex surface are its skin, in one piece a face and without overlap",
          "[overlap]") {
    const std::vector<ConvexPolyhedron> plates = surface_plates(box_surface({1, 2, 3}, false), 0.1);
    CHECK(plates.size() == 6);
    const double skin = 6 - 0.8 * 1.8 * 2.8;
    CHECK(sum_of_volumes(plates) == Approx(skin).epsilon(1e-9));
    CHECK(union_volume(plates) == Approx(skin).epsilon(1e-9));
}

TEST_CASE("Plates behind a hollow reach outward and meet at its edges", "[overlap]") {
    const std::vector<ConvexPolyhedron> plates = surface_plates(box_surface({1, 2, 3}, true), 0.1);
    CHECK(plates.size() == 6);
    const double shell = 1.2 * 2.2 * 3.2 - 6;
    CHECK(union_volume(plates) == Approx(shell).epsilon(1e-9));
    CHECK(sum_of_volumes(plates) == Approx(shell).epsilon(1e-9));
}

TEST_CASE("A thin wall is parted between its two sides", "[overlap]") {
    const std::vector<ConvexPolyhedron> plates = surface_plates(box_surface({1, 1, 0.01}, false), 0.1);
    CHECK(union_volume(plates) == Approx(0.01).epsilon(1e-6));
    CHECK(sum_of_volumes(plates) == Approx(0.01).epsilon(1e-6));
}

TEST_CASE("A body on a flat stretch of many triangles presses once", "[overlap]") {
    // A floor of 2 by 2 squares with an L-shaped hole, so that it is no convex face.
    TriangleMesh floor;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            floor.vertices.emplace_back(x - 1.5, y - 1.5, 0);
        }
    }
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x) {
            const int corner = 4 * y + x;
            if (x + y < 4) {
                floor.triangles.push_back({corner, corner + 1, corner + 5});
                floor.triangles.push_back({corner, corner + 5, corner + 4});
            }
        }
    }
    const std::vector<ConvexPolyhedron> plates = surface_plates(floor, 0.2);
    CHECK(plates.size() > 1);
    const ConvexPolyhedron cube_above = transformed(cube(1), {{-0.1, 0.15, 0.499}, Quat::Identity()});
    OverlapWorkspace workspace;
    double volume = 0;
    for (const ConvexPolyhedron& plate : plates) {
        ContactGeometry g;
        if (overlap(cube_above, {}, plate, {}, Detail::force, false, workspace, g)) {
            volume += g.volume;
        }
    }
    CHECK(volume == Approx(1e-3).epsilon(1e-9));
}
