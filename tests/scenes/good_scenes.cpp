#include <catch2/catch.hpp>

#include <scree/scenes/find_scene.hpp>

#include "small_scene.hpp"

using namespace scree;
using namespace scree::test;

TEST_CASE("What a scene leaves out has the documented default", "[scenes]") {
    const SceneDescription scene = small_scene_with({});
    CHECK(scene.name == "small");
    CHECK(scene.gravity == Vec3(0, 0, -9.81));
    const MaterialDescription& rock = scene.materials.at("rock");
    CHECK(rock.normal_damping == 0.5);
    CHECK(rock.tangential_damping == 0.5);
    CHECK(rock.tangential_ratio == 2.0 / 7.0);
    CHECK(rock.torsion);
    const BodyDescription& ball = scene.bodies.at(2);
    CHECK(ball.name.empty());
    CHECK(ball.orientation.coeffs() == Quat::Identity().coeffs());
    CHECK(ball.velocity == Vec3::Zero());
    CHECK(ball.angular_velocity == Vec3::Zero());
    CHECK(std::holds_alternative<DynamicMotion>(ball.motion));
    CHECK(scene.law.normal == NormalLaw::volume);
    CHECK(scene.law.friction == FrictionLaw::cundall_strack);
    CHECK(scene.law.co_rotation);
    CHECK(scene.stepping.method == SteppingMethod::bdf);
    CHECK(scene.stepping.max_order == 2);
    CHECK_FALSE(scene.stepping.step.has_value());
    CHECK(scene.stepping.rtol == 1e-3);
    CHECK(scene.stepping.atol == 1e-6);
    CHECK(scene.output.every == 0.02);
    CHECK(scene.output.bodies);
    CHECK(std::get<HalfSpace>(scene.shapes.at("floor")).offset == 0);
}

TEST_CASE("A scene file may have comments", "[scenes]") {
    const auto scene = parse_scene("// a line\n" + small_scene + "/* and\n more */", "folder/small.json");
    CHECK(scene.bodies.size() == 3);
}

TEST_CASE("Every value lands where it belongs", "[scenes]") {
    const SceneDescription scene = small_scene_with({
        R"(gravity=[1, 2, 3])",
        R"(materials.steel={"density": 7800, "youngs_modulus": 2e11, "friction": 0.3, "normal_damping": 0.1,
            "tangential_damping": 0.2, "tangential_ratio": 0.4, "torsion": false})",
        R"(pairs=[{"materials": ["rock", "steel"], "friction": 0.25, "torsion": true}])",
        R"(shapes.stone={"mesh": "stone.obj", "scale": [1, 2, 3], "parts": "hull"})",
        R"(shapes.wall={"half_space": {"normal": [0, 3, 4], "offset": 10}})",
        R"(bodies.1.orientation=[0, 0, 0, -2])",
        R"(bodies.1.velocity=[4, 5, 6])",
        R"(bodies.1.angular_velocity=[7, 8, 9])",
        R"(fill=[{"shape": "ball", "material": "steel", "count": 5, "size": [0.8, 1.2],
            "box": [[0, 0, 0], [1, 2, 3]], "seed": 18446744073709551615}])",
        R"(law={"friction": "none", "co_rotation": false})",
        R"(stepping={"max_order": 5, "step": 1e-4, "rtol": 1e-5, "atol": 1e-9, "solver": "newton"})",
        R"(output={"every": 0.5, "bodies": false})",
        R"(end_time=3)",
    });
    CHECK(scene.gravity == Vec3(1, 2, 3));
    const MaterialDescription& steel = scene.materials.at("steel");
    CHECK(steel.density == 7800);
    CHECK(steel.youngs_modulus == 2e11);
    CHECK(steel.friction == 0.3);
    CHECK(steel.normal_damping == 0.1);
    CHECK(steel.tangential_damping == 0.2);
    CHECK(steel.tangential_ratio == 0.4);
    CHECK_FALSE(steel.torsion);
    REQUIRE(scene.pairs.size() == 1);
    CHECK(scene.pairs[0].friction == 0.25);
    CHECK(scene.pairs[0].torsion == true);
    CHECK_FALSE(scene.pairs[0].normal_damping.has_value());
    const auto& stone = std::get<MeshShape>(scene.shapes.at("stone"));
    CHECK(stone.file == "stone.obj");
    CHECK(stone.scale == Vec3(1, 2, 3));
    const auto& wall = std::get<HalfSpace>(scene.shapes.at("wall"));
    CHECK(wall.normal == Vec3(0, 0.6, 0.8));
    CHECK(wall.offset == 2);
    CHECK(scene.bodies[1].orientation.coeffs() == Quat(0, 0, 0, -1).coeffs());
    CHECK(scene.bodies[1].velocity == Vec3(4, 5, 6));
    CHECK(scene.bodies[1].angular_velocity == Vec3(7, 8, 9));
    REQUIRE(scene.fill.size() == 1);
    CHECK(scene.fill[0].count == 5);
    CHECK(scene.fill[0].size == std::array{0.8, 1.2});
    CHECK(scene.fill[0].high == Vec3(1, 2, 3));
    CHECK(scene.fill[0].seed == 18446744073709551615U);
    CHECK(scene.law.friction == FrictionLaw::none);
    CHECK_FALSE(scene.law.co_rotation);
    CHECK(scene.stepping.max_order == 5);
    CHECK(scene.stepping.step == 1e-4);
    CHECK(scene.stepping.rtol == 1e-5);
    CHECK(scene.stepping.atol == 1e-9);
    CHECK(scene.stepping.solver == Solver::newton);
    CHECK(scene.output.every == 0.5);
    CHECK_FALSE(scene.output.bodies);
    CHECK(scene.end_time == 3);
}

TEST_CASE("A setting makes the objects on its way, and a word needs no quotes", "[scenes]") {
    const SceneDescription scene = small_scene_with({"law.friction=none", "bodies.0.name=base"});
    CHECK(scene.law.friction == FrictionLaw::none);
    CHECK(scene.bodies[0].name == "base");
}

TEST_CASE("The later setting of one key holds", "[scenes]") {
    CHECK(small_scene_with({"end_time=2", "end_time=3"}).end_time == 3);
}

TEST_CASE("A scene is called by its file, or by the folder of a scene.json", "[scenes]") {
    CHECK(scene_name("somewhere/tower.json") == "tower");
    CHECK(scene_name("demos/pile/scene.json") == "pile");
}

TEST_CASE("The scenes that come with it can be read, and say what they are", "[scenes]") {
    const auto scenes = shipped_scenes();
    REQUIRE(scenes.size() >= 2);
    for (const ShippedScene& shipped : scenes) {
        CAPTURE(shipped.name);
        CHECK_FALSE(shipped.purpose.empty());
        CHECK(find_scene(shipped.name) == shipped.file);
        CHECK(read_scene(shipped.file).name == shipped.name);
    }
}
