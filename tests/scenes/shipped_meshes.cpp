#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <string>

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
    const std::set<std::string> open{"hopper", "drum"};
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".obj") {
            CAPTURE(entry.path());
            const MeshDescription mesh = describe_mesh(entry.path());
            const std::string name = entry.path().stem();
            CHECK(mesh.closed != open.contains(name));
            CHECK(mesh.convex == (!open.contains(name) && !hollow.contains(name)));
            ++count;
        }
    }
    CHECK(count >= 12);
}

TEST_CASE("The meshes that are bad on purpose are refused for what their first line says", "[scenes]") {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder / "bad")) {
        std::ifstream file(entry.path());
        std::string line;
        std::getline(file, line);
        const std::string mark = "refused, ";
        REQUIRE(line.find(mark) != std::string::npos);
        const std::string why = line.substr(line.find(mark) + mark.size());
        CHECK_THROWS_WITH(describe_mesh(entry.path()), Catch::Contains(why) && Catch::Contains("expected"));
        ++count;
    }
    CHECK(count >= 4);
}

TEST_CASE("The voussoirs among the meshes are those of a round arch: eighteen fill the half ring",
          "[scenes]") {
    for (const int permille : {100, 107, 108, 120}) {
        const double thickness = permille / 1000.0;
        const MeshDescription mesh =
            describe_mesh(folder / ("voussoir_" + std::to_string(permille) + ".obj"));
        const double half = std::numbers::pi / 36;
        // A trapezium of height t cos β between chords, 0.3 deep.
        const double expected = thickness * std::cos(half) * 2 * std::sin(half) * 0.3;
        CHECK(mesh.mass.volume == Approx(expected).epsilon(1e-6));
    }
}
