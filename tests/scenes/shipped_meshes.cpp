#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>

#include <catch2/catch.hpp>

#include <scree/mesh_io/describe_mesh.hpp>

using namespace scree;

namespace {

namespace fs = std::filesystem;

const fs::path folder = SCREE_SOURCE_DIR "/meshes";

struct Known {
    const char* name;
    double volume;  // m³
    int vertices, faces;
};

const double root2 = std::numbers::sqrt2;
const double root3 = std::numbers::sqrt3;
const double root5 = std::sqrt(5.0);
const Known known[] = {
    {"cube", 1, 8, 6},
    {"slab", 0.1, 8, 6},
    {"hexagonal_prism", 0.6 * 1.5 * root3 * 0.25, 12, 8},
    {"tetrahedron", root2 / 12, 4, 4},
    {"octahedron", root2 / 3, 6, 8},
    {"icosahedron", 5 * (3 + root5) / 12, 12, 20},
    {"dodecahedron", (15 + 7 * root5) / 4, 20, 12},
};

}  // namespace

TEST_CASE("The regular solids among the meshes have their volumes, vertices and faces", "[scenes]") {
    for (const Known& solid : known) {
        CAPTURE(solid.name);
        const MeshDescription mesh = describe_mesh(folder / (std::string(solid.name) + ".obj"));
        CHECK(mesh.mass.volume == Approx(solid.volume).epsilon(1e-6));
        CHECK(mesh.vertices() == solid.vertices);
        CHECK(mesh.faces() == solid.faces);
    }
}

TEST_CASE("All meshes that come with scree are closed, and convex but for those that show parts and surfaces",
          "[scenes]") {
    const std::set<std::string> hollow{"ell", "gear", "arch", "mug"};
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".obj") {
            CAPTURE(entry.path());
            const MeshDescription mesh = describe_mesh(entry.path());
            const std::string name = entry.path().stem();
            CHECK(mesh.closed == (name != "hopper"));
            CHECK(mesh.convex == (name != "hopper" && !hollow.contains(name)));
            ++count;
        }
    }
    CHECK(count >= 11);
}
