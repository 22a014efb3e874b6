#include <algorithm>

#include <catch2/catch.hpp>

#include <scree/scenes/simulation.hpp>
#include <tests/support/mesh_files.hpp>

#include "small_scene.hpp"

using namespace scree;
using namespace scree::test;

namespace {

const std::string in_plane = "law.friction=cundall_strack_2d";

// The one line that refuses the small scene with these settings; empty when it is accepted and made.
std::string refusal(const std::vector<std::string>& settings) {
    try {
        const Simulation simulation(small_scene_with(settings));
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

struct OffPlane {
    const char* setting;
    const char* message;
};

const OffPlane off_plane[] = {
    {"gravity=[0,1,-9]", "gravity.1: found 1.0, expected 0, for law.friction is for motion in the x–z plane"},
    {"bodies.1.position=[0,0.01,0.05]", "bodies.1.position.1: found 0.01, expected 0"},
    {"bodies.0.position=[0,-1,0]", ""},  // along the half-space's own plane
    {"bodies.2.velocity=[1,1e-9,0]", "bodies.2.velocity.1: found 1e-09, expected 0"},
    {"bodies.2.velocity=[1,0,2]", ""},
    {"bodies.2.angular_velocity=[0.5,0,0]", "bodies.2.angular_velocity.0: found 0.5, expected 0"},
    {"bodies.2.angular_velocity=[0,0,0.5]", "bodies.2.angular_velocity.2: found 0.5, expected 0"},
    {"bodies.2.angular_velocity=[0,3,0]", ""},
    {"bodies.1.orientation=[1,0.1,0,0]", "bodies.1.orientation: found a turn about another axis than y"},
    {"bodies.1.orientation=[1,0,0,0.1]", "bodies.1.orientation: found a turn about another axis than y"},
    {"bodies.1.orientation=[1,0,0.1,0]", ""},
    {"shapes.floor.half_space.normal=[0,0.6,0.8]", "shapes.floor.half_space.normal.1: found 0.6, expected 0"},
    {"shapes.floor.half_space.normal=[0.6,0,0.8]", ""},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1,\"box\":[[2,2,2],[3,3,3]]}]",
     "fill: found bodies at random, expected none"},
};

TriangleMesh shifted(TriangleMesh mesh, const Vec3& by) {
    for (Vec3& vertex : mesh.vertices) {
        vertex += by;
    }
    return mesh;
}

}  // namespace

TEST_CASE("The two-dimensional law refuses what is off the x–z plane, other laws do not", "[scenes]") {
    for (const OffPlane& off : off_plane) {
        CAPTURE(off.setting);
        CHECK(refusal({off.setting}).empty());
        const std::string message = refusal({in_plane, off.setting});
        CHECK_THAT(message, Catch::Contains(off.message));
        CHECK(message.empty() == std::string(off.message).empty());
        CHECK(std::count(message.begin(), message.end(), '\n') == 0);
    }
    CHECK(refusal({in_plane}).empty());
}

TEST_CASE("A mesh is in the plane when the plane halves it where its body is", "[scenes]") {
    const MeshFiles files;
    const std::string centred = files.obj("centred.obj", cube_mesh()).string();
    const std::string aside = files.obj("aside.obj", shifted(cube_mesh(), {0, 0.5, 0})).string();
    TriangleMesh lopsided = cube_mesh();
    lopsided.vertices[0] += Vec3(0, 0.1, 0);
    const std::string crooked = files.obj("crooked.obj", lopsided).string();
    const auto with = [&](const std::string& mesh, const char* position) {
        return refusal({in_plane, R"(shapes.crate={"mesh": ")" + mesh + R"(", "scale": 0.1})",
                        std::string("bodies.1.position=") + position});
    };
    CHECK(with(centred, "[0,0,0.05]").empty());
    CHECK(with(aside, "[0,-0.05,0.05]").empty());
    const char* message = "bodies.1: found \"crate\", which the plane y = 0 does not halve, expected a mesh";
    CHECK_THAT(with(centred, "[0,0.01,0.05]"), Catch::Contains(message));
    CHECK_THAT(with(aside, "[0,0,0.05]"), Catch::Contains(message));
    CHECK_THAT(with(crooked, "[0,0,0.05]"), Catch::Contains(message));
}
