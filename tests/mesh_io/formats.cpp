// What each kind of file may hold: several meshes, transforms of nodes, axes and units.

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/mesh/mass_properties.hpp>
#include <scree/mesh_io/load_mesh.hpp>

#include <tests/support/mesh_files.hpp>
#include <tests/support/random.hpp>
#include <tests/support/shapes.hpp>

using namespace scree;
using namespace scree::test;

namespace {

/// The tetrahedron 0, x, 2y, 3z of the COLLADA files.
TriangleMesh corner_mesh() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// The deviation [m] of two sets of points, in any order.
double distance(const std::vector<Vec3>& points, const std::vector<Vec3>& expected) {
    double largest = points.size() == expected.size() ? 0 : 1e9;
    for (const Vec3& p : points) {
        double nearest = 1e9;
        for (const Vec3& e : expected) {
            nearest = std::min(nearest, (p - e).norm());
        }
        largest = std::max(largest, nearest);
    }
    return largest;
}

std::vector<Vec3> joined(std::vector<Vec3> points, const std::vector<Vec3>& more) {
    points.insert(points.end(), more.begin(), more.end());
    return points;
}

/// From glTF's axes, y up, to ours.
std::vector<Vec3> z_up(std::vector<Vec3> points) {
    for (Vec3& p : points) {
        p = Vec3(p.x(), -p.z(), p.y());
    }
    return points;
}

TriangleMesh turned_cube() {
    Random random(31);
    TriangleMesh cube = cube_mesh();
    cube.vertices = as_float(turned(cube.vertices, random.rotation()));
    return cube;
}

}  // namespace

TEST_CASE("PLY is the same as text and as bytes of either order", "[mesh_io]") {
    const MeshFiles files;
    const TriangleMesh cube = turned_cube();
    for (const PlyKind kind : {PlyKind::ascii, PlyKind::little_endian, PlyKind::big_endian}) {
        const TriangleMesh mesh = load_mesh(files.ply("cube.ply", cube, kind));
        CHECK(distance(mesh.vertices, cube.vertices) == 0);
        CHECK(mesh.triangles.size() == 12);
        CHECK(mass_properties(mesh).volume == Approx(1).epsilon(1e-6));
    }
}

TEST_CASE("PLY may have polygons, properties that do not matter, and doubles", "[mesh_io]") {
    const MeshFiles files;
    const TriangleMesh mesh = load_mesh(
        files.text("pyramid.ply",
                   "ply\nformat ascii 1.0\ncomment a pyramid\nobj_info none\nelement vertex 5\n"
                   "property double x\nproperty double y\nproperty double z\nproperty uchar red\n"
                   "element face 5\nproperty list uchar uint vertex_index\nelement edge 1\nproperty int a\n"
                   "end_header\n0 0 0 255\n1 0 0 255\n1 1 0 255\n0 1 0 255\n0 0 3 255\n"
                   "4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n7\n"));
    CHECK(mesh.triangles.size() == 6);
    CHECK(mass_properties(mesh).volume == Approx(1).epsilon(1e-15));
}

TEST_CASE("All solids of an STL file are joined, and a binary one may begin with that word", "[mesh_io]") {
    const MeshFiles files;
    const TriangleMesh cube = cube_mesh();
    TriangleMesh other = cube;
    other.vertices = turned(cube.vertices, Quat::Identity(), 1, Vec3(3, 0, 0));
    const std::string both =
        contents(files.ascii_stl("a.stl", cube)) + contents(files.ascii_stl("b.stl", other));
    const TriangleMesh mesh = load_mesh(files.text("both.stl", both));
    CHECK(distance(mesh.vertices, joined(cube.vertices, other.vertices)) == 0);
    CHECK(mass_properties(mesh).volume == 2);

    std::string bytes = contents(files.binary_stl("c.stl", cube));
    bytes.replace(0, 10, "solid cube");
    CHECK(distance(load_mesh(files.text("c.stl", bytes)).vertices, cube.vertices) == 0);
}

TEST_CASE("All objects and groups of an OBJ file are joined, its materials not asked for", "[mesh_io]") {
    const MeshFiles files;
    const TriangleMesh mesh =
        load_mesh(files.text("two.obj",
                             "mtllib none.mtl\no one\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nusemtl red\n"
                             "f 1 3 2\nf 1 2 4\ng rest\nf 2 3 4\nf 3 1 4\no two\n"
                             "v 5 0 0 1\nv 6 0 0 1\nv 5 2 0 1\nv 5 0 3 1\nvt 0 0\nvn 0 0 1\n"
                             "f -4/1/1 -2/1/1 -3/1/1\nf -4//1 -3//1 -1//1\nf 6/1 7/1 8/1\nf 7 5 8\n"));
    const std::vector<Vec3> one = corner_mesh().vertices;
    CHECK(distance(mesh.vertices, joined(one, turned(one, Quat::Identity(), 1, Vec3(5, 0, 0)))) == 0);
    CHECK(mass_properties(mesh).volume == Approx(2).epsilon(1e-15));
}

TEST_CASE("glTF is the same with its numbers in the file, beside it and in binary", "[mesh_io]") {
    const MeshFiles files;
    const TriangleMesh cube = turned_cube();
    const std::string nodes = R"([{"mesh":0}])";
    for (const auto& file : {files.gltf("embedded.gltf", {cube}, nodes, GltfBuffer::embedded),
                             files.gltf("beside.gltf", {cube}, nodes, GltfBuffer::beside),
                             files.gltf("binary.glb", {cube}, nodes, GltfBuffer::binary)}) {
        INFO(file);
        CHECK(distance(load_mesh(file).vertices, z_up(cube.vertices)) == 0);
    }
}

TEST_CASE("glTF's nodes place their meshes, one mesh in as many places as nodes name it", "[mesh_io]") {
    const MeshFiles files;
    // Node 0 shifts and turns by 90° about y; below it a cube twice and a tetrahedron scaled by a matrix. The
    // last node is in no scene.
    const std::string nodes = R"([
        {"children":[1,2,3],"translation":[10,0,0],"rotation":[0,0.7071067811865476,0,0.7071067811865476]},
        {"mesh":0}, {"mesh":0,"translation":[0,5,0],"scale":[1,2,3]},
        {"mesh":1,"matrix":[2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,7,1]},
        {"mesh":0,"translation":[100,0,0]}])";
    const GltfBuffer where = GENERATE(GltfBuffer::embedded, GltfBuffer::beside, GltfBuffer::binary);
    const std::string name = where == GltfBuffer::binary ? "tree.glb" : "tree.gltf";
    const TriangleMesh mesh = load_mesh(files.gltf(name, {cube_mesh(), corner_mesh()}, nodes, where));

    std::vector<Vec3> tall = cube_corners();
    for (Vec3& p : tall) {
        p = p.cwiseProduct(Vec3(1, 2, 3)) + Vec3(0, 5, 0);
    }
    const std::vector<Vec3> large = turned(corner_mesh().vertices, Quat::Identity(), 2, Vec3(0, 0, 7));
    const Quat quarter(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY()));
    const std::vector<Vec3> inner = joined(joined(cube_corners(), tall), large);
    const std::vector<Vec3> expected = z_up(turned(inner, quarter, 1, Vec3(10, 0, 0)));
    CHECK(distance(mesh.vertices, expected) < 2e-6);  // single precision at 10 m
    CHECK(mass_properties(mesh).volume == Approx(1 + 6 + 8).epsilon(1e-6));
}

TEST_CASE("COLLADA's nodes place their meshes, by any of its transforms", "[mesh_io]") {
    const MeshFiles files;
    const std::string nodes = R"(
        <node><translate>1 2 3</translate><rotate>0 0 1 90</rotate><scale>1 1 2</scale>
          <instance_geometry url="#corner"/>
          <node><matrix>1 0 0 0  0 1 0 0  0 0 1 5  0 0 0 1</matrix><instance_geometry url="#corner"/></node>
        </node>)";
    const TriangleMesh mesh = load_mesh(files.collada("nodes.dae", "<up_axis>Z_UP</up_axis>", 1, nodes));
    std::vector<Vec3> expected;
    for (const double up : {0.0, 5.0}) {
        for (const Vec3& p : corner_mesh().vertices) {
            expected.emplace_back(1 - p.y(), 2 + p.x(), 3 + 2 * (p.z() + up));
        }
    }
    CHECK(distance(mesh.vertices, expected) < 2e-6);
    CHECK(mass_properties(mesh).volume == Approx(4).epsilon(1e-6));
}

TEST_CASE("COLLADA with x up is turned to z up", "[mesh_io]") {
    const MeshFiles files;
    const TriangleMesh mesh = load_mesh(files.collada("x.dae", "<up_axis>X_UP</up_axis>", 1));
    // Its right is −y and its z comes towards the viewer, as in the other two.
    const std::vector<Vec3> expected{{0, 0, 0}, {0, 0, 1}, {-2, 0, 0}, {0, -3, 0}};
    CHECK(distance(mesh.vertices, expected) < 1e-9);
}

TEST_CASE("COLLADA is in metres by its unit, the translations of its nodes too", "[mesh_io]") {
    const MeshFiles files;
    const std::string nodes =
        R"(<node><translate>100 0 0</translate><instance_geometry url="#corner"/></node>)";
    for (const double unit : {0.001, 0.0254, 1.0, 1000.0}) {
        const TriangleMesh mesh =
            load_mesh(files.collada("unit.dae", "<up_axis>Z_UP</up_axis>", unit, nodes));
        const std::vector<Vec3> expected =
            turned(corner_mesh().vertices, Quat::Identity(), unit, Vec3(100 * unit, 0, 0));
        CHECK(distance(mesh.vertices, expected) < 1e-5 * unit);
    }
}

TEST_CASE("A COLLADA mesh that is mirrored by a node keeps its triangles outward", "[mesh_io]") {
    const MeshFiles files;
    const std::string nodes = R"(<node><scale>1 -1 1</scale><instance_geometry url="#corner"/></node>)";
    const TriangleMesh mesh = load_mesh(files.collada("mirrored.dae", "", 1, nodes));
    CHECK(mass_properties(mesh).volume == Approx(1).epsilon(1e-6));
}
