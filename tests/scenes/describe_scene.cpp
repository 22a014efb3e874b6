#include <algorithm>

#include <catch2/catch.hpp>

#include <scree/scenes/describe_scene.hpp>

#include <tests/scenes/small_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

std::vector<std::string> lines_of(const std::vector<std::string>& settings) {
    return describe_scene(Simulation(small_scene_with(settings)));
}

void check_has(const std::vector<std::string>& lines, const std::string& wanted) {
    CAPTURE(wanted, lines);
    CHECK(std::find(lines.begin(), lines.end(), wanted) != lines.end());
}

}  // namespace

TEST_CASE("A scene is described by what a run will use", "[scenes]") {
    const auto lines = lines_of({});
    check_has(lines, "small: 3 bodies for 0.1 s, an output every 0.02 s");
    check_has(lines, "gravity: 0 0 -9.81 m/s²");
    check_has(lines, "bodies: 2 dynamic, 1.36136 to 2.6 kg, 3.96136 kg together; 1 fixed; 0 prescribed");
    check_has(lines, "shape: ball, sphere, radius 0.05 m");
    check_has(lines, "shape: crate, box 0.1 0.1 0.1 m");
    check_has(lines, "shape: floor, half-space, solid where 0 0 1 · x < 0 m");
    check_has(lines,
              "material: rock, 2600 kg/m³; on itself Y 1e+09 Pa, friction 0.5, damping 0.5 normal, 0.5 "
              "tangential, Yt/Y 0.285714, torsion on");
    check_has(lines,
              "law: normal volume, friction cundall_strack, damping patch, normal damping by length, "
              "tangential stiffness length, "
              "co-rotation on, reduced mass point");
    check_has(lines, "stepping: bdf, adaptive step, orders 1 to 2, rtol 0.001, atol 1e-06, solver auto");
    check_has(lines, "output: summary.json bodies.csv energy.csv replay.glb");
}

TEST_CASE("What a run will write is described", "[scenes]") {
    check_has(
        lines_of({"output={\"bodies\":false,\"contacts\":true,\"replay\":false,\"checkpoint_every\":0.5}"}),
        "output: summary.json energy.csv contacts.csv, a checkpoint every 0.5 s");
}

TEST_CASE("Pairs are described by what they come to, with the mixing rules", "[scenes]") {
    const auto lines = lines_of(
        {"materials.ice={\"density\":900,\"youngs_modulus\":1e9,\"friction\":0.02,\"torsion\":false}",
         "pairs=[{\"materials\":[\"ice\",\"rock\"],\"friction\":0.05}]"});
    check_has(lines,
              "pair: ice on rock, Y 1e+09 Pa, friction 0.05, damping 0.5 normal, 0.5 tangential, Yt/Y "
              "0.285714, torsion off");
}

TEST_CASE("Bodies that move as prescribed are described by their motion, those of the same together",
          "[scenes]") {
    const std::string turning = "{\"angular_velocity\":[0,1,0],\"about\":[1,0,0]}";
    const auto lines = lines_of({"bodies.0.motion={\"surface_velocity\":[2,0,0]}",
                                 "bodies.1.motion=" + turning, "bodies.2.motion=" + turning});
    check_has(lines, "bodies: 0 dynamic; 0 fixed; 3 prescribed");
    check_has(lines, "motion: ground conveys by 2 0 0 m/s");
    check_has(lines, "motion: block and 1 more, each turns by 0 1 0 rad/s about 1 0 0 m");
    check_has(lines_of({"bodies.0.motion={\"velocity\":[0,0,1],\"amplitude\":0.01,\"frequency\":50}"}),
              "motion: ground vibrates by 0.01 m at 50 Hz along 0 0 1");
}

TEST_CASE("What Bullet's own solver will use is described for it", "[scenes]") {
    const auto lines = lines_of({"stepping={\"method\":\"bullet\",\"step\":0.01,\"iterations\":20}"});
    check_has(lines, "stepping: bullet, step 0.01 s at most, 20 iterations, GJK, friction directions 1");
    check_has(lines, "law: none of scree's, impulses of Bullet's own solver");
    check_has(lines, "material: rock, 2600 kg/m³; on itself friction 0.5, restitution 0.506277");
}

TEST_CASE("A mesh is described by its hull, and a note says where that is not the mesh", "[scenes]") {
    const auto lines = lines_of(
        {"shapes.crate={\"mesh\":\"" SCREE_SOURCE_DIR "/meshes/cube.obj\",\"scale\":[0.1,0.2,0.1]}"});
    check_has(lines, "shape: crate, mesh " SCREE_SOURCE_DIR
                     "/meshes/cube.obj times 0.1 0.2 0.1, 8 vertices, 6 faces, 0.002 m³");
}
