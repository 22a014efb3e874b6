#include <scree/mesh_io/describe_mesh.hpp>

#include <catch2/catch.hpp>

#include <tests/support/mesh_files.hpp>
#include <tests/support/random.hpp>
#include <tests/support/shapes.hpp>

using namespace scree;
using test::MeshFiles;

TEST_CASE("A cube's description is that of paper", "[mesh_io]") {
    const MeshFiles files;
    const auto file = files.obj("cube.obj", test::cube_mesh());
    const MeshDescription cube = describe_mesh(file);
    CHECK(cube.mass.volume == 1);
    CHECK(cube.mass.centroid.norm() == 0);
    CHECK((cube.mass.inertia - Mat3::Identity() / 6).norm() < 1e-15);
    CHECK(cube.vertices() == 8);
    CHECK(cube.faces() == 6);
    CHECK(cube.closed);
    CHECK(cube.convex);
    CHECK(cube.hull_volume() == 1);
    CHECK(cube.hull.largest_move == 0);

    const MeshDescription scaled = describe_mesh(file, Vec3(1, 2, 0.5));
    CHECK(scaled.mass.volume == Approx(1).epsilon(1e-15));
    CHECK(scaled.mass.inertia(0, 0) == Approx((4 + 0.25) / 12).epsilon(1e-15));
    CHECK(scaled.mass.inertia(1, 1) == Approx((1 + 0.25) / 12).epsilon(1e-15));
}

TEST_CASE("A cube turned in its file, in single precision", "[mesh_io]") {
    const MeshFiles files;
    test::Random random(1);
    for (const double size : {1e-6, 1e-3, 1.0, 1e3}) {
        TriangleMesh mesh = test::cube_mesh();
        mesh.vertices = test::turned(mesh.vertices, random.rotation(), size, size * random.vector());
        const MeshDescription cube = describe_mesh(files.binary_stl("cube.stl", mesh));
        CHECK(cube.vertices() == 8);
        CHECK(cube.faces() == 6);
        CHECK(cube.convex);
        CHECK(cube.mass.volume == Approx(std::pow(size, 3)).epsilon(1e-6));
        CHECK(cube.hull_volume() == Approx(std::pow(size, 3)).epsilon(1e-6));
        CHECK((cube.mass.inertia - std::pow(size, 5) / 6 * Mat3::Identity()).norm() <
              1e-6 * std::pow(size, 5));
        CHECK(cube.hull.largest_move > 0);
        CHECK(cube.hull.largest_move < 1e-6 * size);
    }
}

TEST_CASE("A mesh that is not convex gives its hull and the ratio of volumes", "[mesh_io]") {
    // A cube whose top is pushed in to the middle: 5/6 of its volume.
    TriangleMesh dented = test::cube_mesh();
    std::erase_if(dented.triangles, [&](const std::array<int, 3>& t) {
        return dented.vertices[t[0]].z() > 0 && dented.vertices[t[1]].z() > 0 &&
               dented.vertices[t[2]].z() > 0;
    });
    const int middle = static_cast<int>(dented.vertices.size());
    dented.vertices.emplace_back(0, 0, 0);
    const auto corner = [&](double x, double y) {
        for (int v = 0; v < middle; ++v) {
            if (dented.vertices[v] == Vec3(x, y, 0.5)) {
                return v;
            }
        }
        return -1;
    };
    const std::array<int, 4> ring{corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)};
    for (std::size_t i = 0; i < 4; ++i) {
        dented.triangles.push_back({ring[i], ring[(i + 1) % 4], middle});
    }
    const MeshFiles files;
    const MeshDescription description = describe_mesh(files.obj("dented.obj", dented));
    CHECK(description.closed);
    CHECK_FALSE(description.convex);
    CHECK(description.faces() == 6);
    CHECK(description.hull_volume() == 1);
    CHECK(description.mass.volume == Approx(5.0 / 6).epsilon(1e-15));
    CHECK(description.volume_ratio() == Approx(5.0 / 6).epsilon(1e-15));
}

TEST_CASE("An open mesh has the mass properties of its hull", "[mesh_io]") {
    TriangleMesh open = test::cube_mesh();
    open.triangles.pop_back();
    const MeshFiles files;
    const MeshDescription description = describe_mesh(files.obj("open.obj", open));
    CHECK_FALSE(description.closed);
    CHECK_FALSE(description.convex);
    CHECK(description.mass.volume == 1);
    CHECK(description.volume_ratio() == 1);
}

TEST_CASE("A mesh that is inside out, or inconsistent, is turned", "[mesh_io]") {
    TriangleMesh mesh = test::cube_mesh();
    const std::size_t step = GENERATE(1, 5);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
        std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    }
    const MeshFiles files;
    const MeshDescription description = describe_mesh(files.ascii_stl("turned.stl", mesh));
    CHECK(description.closed);
    CHECK(description.convex);
    CHECK(description.surface.flipped);
    CHECK(description.mass.volume == 1);
}
