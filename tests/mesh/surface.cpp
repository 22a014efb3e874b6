#include <scree/mesh/surface.hpp>

#include <utility>

#include <catch2/catch.hpp>

#include <scree/mesh/mass_properties.hpp>

#include <tests/support/mesh_files.hpp>

using namespace scree;
using test::cube_mesh;

namespace {

void turn(TriangleMesh& mesh, std::size_t triangle) {
    std::swap(mesh.triangles[triangle][0], mesh.triangles[triangle][1]);
}

/// Appends a scaled copy, inside out if the scale is negative.
void append(TriangleMesh& mesh, const TriangleMesh& other, double scale) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Vec3& v : other.vertices) {
        mesh.vertices.emplace_back(scale * v);
    }
    for (const auto& [a, b, c] : other.triangles) {
        mesh.triangles.push_back({first + a, first + b, first + c});
    }
}

}  // namespace

TEST_CASE("A closed outward surface is left alone", "[mesh]") {
    const TriangleMesh cube = cube_mesh();
    const Surface surface = oriented_surface(cube);
    CHECK(surface.closed);
    CHECK_FALSE(surface.flipped);
    CHECK(surface.mesh.triangles == cube.triangles);
}

TEST_CASE("A hole opens a surface, a triangle without area does not", "[mesh]") {
    TriangleMesh cube = cube_mesh();
    cube.triangles.push_back({1, 1, 2});
    CHECK(oriented_surface(cube).closed);
    cube.triangles.resize(11);
    CHECK_FALSE(oriented_surface(cube).closed);
    CHECK_FALSE(oriented_surface({}).closed);
}

TEST_CASE("Inside-out and contradicting triangles are turned", "[mesh]") {
    TriangleMesh cube = cube_mesh();
    SECTION("all of them") {
        for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
            turn(cube, t);
        }
    }
    SECTION("some of them") {
        for (const std::size_t t : {0, 3, 4, 5, 9}) {
            turn(cube, t);
        }
    }
    const Surface surface = oriented_surface(cube);
    CHECK(surface.closed);
    CHECK(surface.flipped);
    CHECK(mass_properties(surface.mesh).volume == Approx(1).epsilon(1e-15));
}

TEST_CASE("A cavity that the file turns inwards stays a cavity", "[mesh]") {
    TriangleMesh hollow = cube_mesh();
    append(hollow, cube_mesh(), -0.5);
    const Surface surface = oriented_surface(hollow);
    CHECK(surface.closed);
    CHECK_FALSE(surface.flipped);
    CHECK(mass_properties(surface.mesh).volume == Approx(1 - 0.125).epsilon(1e-15));
}

TEST_CASE("A sheet that is folded back on itself encloses nothing", "[mesh]") {
    const TriangleMesh sheet{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, {{{0, 1, 2}}, {{0, 2, 1}}}};
    CHECK_FALSE(oriented_surface(sheet).closed);
}
