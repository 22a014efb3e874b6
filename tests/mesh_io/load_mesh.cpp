#include <scree/mesh_io/load_mesh.hpp>

#include <filesystem>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>

#include <scree/mesh/mass_properties.hpp>
#include <scree/mesh_io/describe_mesh.hpp>

#include <tests/support/mesh_files.hpp>
#include <tests/support/random.hpp>
#include <tests/support/shapes.hpp>

using namespace scree;
using Catch::Matchers::Contains;
using test::MeshFiles;

namespace {

/// The deviation of a mesh's vertices from those expected, in any order.
double distance(const std::vector<Vec3>& vertices, const std::vector<Vec3>& expected) {
    double largest = vertices.size() == expected.size() ? 0 : 1;
    for (const Vec3& v : vertices) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& e : expected) {
            nearest = std::min(nearest, (v - e).norm());
        }
        largest = std::max(largest, nearest);
    }
    return largest;
}

}  // namespace

TEST_CASE("A cube comes out of every kind of file with its 8 vertices and 12 triangles", "[mesh_io]") {
    const MeshFiles files;
    const TriangleMesh cube = test::cube_mesh();
    for (const auto& file : {files.obj("cube.obj", cube), files.ascii_stl("ascii.stl", cube),
                             files.binary_stl("binary.stl", cube), files.ply("cube.ply", cube)}) {
        INFO(file);
        const TriangleMesh mesh = load_mesh(file);
        CHECK(distance(mesh.vertices, cube.vertices) == 0);
        CHECK(mesh.triangles.size() == 12);
        CHECK(mass_properties(mesh).volume == 1);
    }
}

TEST_CASE("Coordinates are the file's in single precision, times the scale", "[mesh_io]") {
    const MeshFiles files;
    test::Random random(1);
    TriangleMesh turned = test::cube_mesh();
    turned.vertices = test::as_float(test::turned(turned.vertices, random.rotation()));
    const auto file = files.binary_stl("turned.stl", turned);
    CHECK(distance(load_mesh(file).vertices, turned.vertices) == 0);

    const Vec3 scale(0.1, 2, 1e-3);
    std::vector<Vec3> scaled = turned.vertices;
    for (Vec3& v : scaled) {
        v = v.cwiseProduct(scale);
    }
    CHECK(distance(load_mesh(file, scale).vertices, scaled) == 0);
    CHECK_THROWS_AS(load_mesh(file, Vec3(1, 0, 1)), std::invalid_argument);
    CHECK_THROWS_AS(load_mesh(file, Vec3::Constant(std::nan(""))), std::invalid_argument);
}

TEST_CASE("Polygons are split, also those with a notch", "[mesh_io]") {
    const MeshFiles files;
    // An L of area 3 and height 1: 6-cornered faces below and above, with their notch at different places.
    const auto file = files.text("l.obj",
                                 "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
                                 "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n"
                                 "f 6 5 4 3 2 1\nf 10 11 12 7 8 9\n"
                                 "f 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n");
    const TriangleMesh mesh = load_mesh(file);
    CHECK(mesh.triangles.size() == 2 * 4 + 6 * 2);
    CHECK(mass_properties(mesh).volume == Approx(3).epsilon(1e-15));
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 twice = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
        area += twice.norm() / 2;
    }
    CHECK(area == Approx(2 * 3 + 8).epsilon(1e-15));  // no triangle lies over another
}

TEST_CASE("glTF is turned to z up, its nodes' transforms applied", "[mesh_io]") {
    const MeshFiles files;
    const TriangleMesh mesh = load_mesh(files.gltf("cube.gltf", test::cube_mesh(), {1, 2, 3}));
    // File: x right, y up, z to the viewer. Ours: z up, −y is the file's z.
    CHECK(distance(mesh.vertices, test::turned(test::cube_corners(), Quat::Identity(), 1, Vec3(1, -3, 2))) <
          1e-15);
    CHECK(mass_properties(mesh).volume == Approx(1).epsilon(1e-14));
}

TEST_CASE("COLLADA is turned to z up and to metres by what it declares", "[mesh_io]") {
    const MeshFiles files;
    // The tetrahedron 0, x, 2y, 3z of the file, in centimetres.
    const std::vector<std::pair<std::string, std::vector<Vec3>>> cases{
        {"<up_axis>Z_UP</up_axis>", {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}},
        {"<up_axis>Y_UP</up_axis>", {{0, 0, 0}, {1, 0, 0}, {0, 0, 2}, {0, -3, 0}}},
        {"", {{0, 0, 0}, {1, 0, 0}, {0, 0, 2}, {0, -3, 0}}},
    };
    for (const auto& [axis, expected] : cases) {
        INFO(axis);
        const TriangleMesh mesh = load_mesh(files.collada("corner.dae", axis, 0.01));
        // The unit is single precision too.
        CHECK(distance(mesh.vertices, test::turned(expected, Quat::Identity(), 0.01)) < 1e-9);
        CHECK(mass_properties(mesh).volume == Approx(1e-6).epsilon(1e-6));
    }
}

TEST_CASE("A mirrored node keeps its triangles outward", "[mesh_io]") {
    const MeshFiles files;
    const auto file = files.gltf("mirrored.gltf", test::cube_mesh(), {0, 0, 0}, {-1, 1, 2});
    CHECK(mass_properties(load_mesh(file)).volume == Approx(2).epsilon(1e-14));
}

TEST_CASE("Files that are too large are refused before they are read", "[mesh_io]") {
    const MeshFiles files;
    const auto file = files.text("large.stl", "solid\n");
    std::filesystem::resize_file(file, (std::uintmax_t{1} << 30) + 1);  // sparse: takes no room
    CHECK_THROWS_WITH(load_mesh(file), Contains("found 1073741825 bytes"));
}

TEST_CASE("Damaged files end in an error or in a mesh, not in a crash", "[mesh_io]") {
    const MeshFiles files;
    test::Random random(2);
    const TriangleMesh cube = test::cube_mesh();
    for (const auto& whole : {files.obj("cube.obj", cube), files.ascii_stl("ascii.stl", cube),
                              files.binary_stl("binary.stl", cube)}) {
        const std::string text = test::contents(whole);
        for (int i = 0; i < 100; ++i) {
            std::string damaged = text;
            for (int k = 0; k < 1 + i % 5; ++k) {
                damaged[static_cast<std::size_t>(random.uniform(0, static_cast<double>(text.size())))] =
                    static_cast<char>(random.uniform(0, 256));
            }
            if (i % 2 == 0) {
                damaged.resize(static_cast<std::size_t>(random.uniform(1, static_cast<double>(text.size()))));
            }
            try {
                describe_mesh(files.text("damaged" + whole.extension().string(), damaged));
            } catch (const MeshError&) {
            }
        }
    }
    SUCCEED();
}
