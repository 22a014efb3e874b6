#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include <scree/output/gltf.hpp>

#include <tests/support/glb.hpp>
#include <tests/support/shapes.hpp>

using namespace scree;
using namespace scree::test;

namespace {

namespace fs = std::filesystem;

const fs::path spool_file = fs::temp_directory_path() / "scree_gltf_poses";

/// One body a kind of shape, on a ground that stays where it is.
ShownScene shapes_on_ground() {
    ShownScene scene;
    const auto add = [&](const std::string& name, const Shape& shape, bool moves) {
        scene.meshes.push_back(shown_mesh(name, shape, {Vec3(0.1, 0, 0), Quat::Identity()}));
        const auto number = static_cast<double>(scene.bodies.size());
        scene.bodies.push_back({name, scene.bodies.size(), 1, moves, {Vec3(number, 0, 2), Quat::Identity()}});
    };
    add("ground", HalfSpace{}, false);
    add("box", make_box({0.1, 0.2, 0.3}), true);
    add("ball", Sphere{0.5}, true);
    add("cone", make_frustum(0.2, 0, 0.3), true);
    add("cylinder", make_frustum(0.2, 0.2, 0.3), true);
    add("capsule", make_capsule(0.1, 0.2), true);
    scene.bodies.push_back({"accessor", 1, 2.5, true, {Vec3(-1, 0, 0), Quat::Identity()}});  // shares the box
    return scene;
}

Quat turned(double angle) {
    return Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
}

/// Frames 0.1 s apart in which body i is at (i, frame, 1) and has turned by frame · 100°.
PoseSpool spool_of(const ShownScene& scene, int frames) {
    const std::size_t moving = scene.bodies.size() - 1;
    {
        PoseSpool spool(spool_file, moving);
        for (int frame = 0; frame < frames; ++frame) {
            std::vector<Pose> poses;
            for (std::size_t i = 0; i < moving; ++i) {
                poses.push_back({Vec3(static_cast<double>(i), frame, 1), turned(frame * 1.75)});
            }
            spool.add(0.1 * frame, static_cast<std::size_t>(frame), poses);
        }
    }
    return PoseSpool(spool_file, moving, fs::file_size(spool_file));
}

Vec3 middle_of(const ShownMesh& mesh) {
    Vec3 sum = Vec3::Zero();
    for (const ShownMesh::Corner& corner : mesh.corners) {
        sum += corner.position;
    }
    return sum / static_cast<double>(mesh.corners.size());
}

const nlohmann::json& node_named(const Glb& glb, const std::string& name) {
    const auto& nodes = glb.json.at("nodes");
    const auto found =
        std::find_if(nodes.begin(), nodes.end(), [&](const auto& node) { return node.at("name") == name; });
    REQUIRE(found != nodes.end());
    return *found;
}

}  // namespace

TEST_CASE("The surfaces that are shown are closed, and face out", "[output]") {
    const auto solid = GENERATE(Shape(make_box({1, 2, 3})), Shape(Sphere{2}), Shape(make_frustum(1, 0.5, 2)),
                                Shape(make_frustum(0, 1, 1)), Shape(make_capsule(0.5, 1)));
    const ShownMesh mesh = shown_mesh("solid", solid, {Vec3(1, 2, 3), turned(0.4)});
    double volume = 0;
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
        const Vec3& a = mesh.corners[i].position;
        const Vec3 normal = (mesh.corners[i + 1].position - a).cross(mesh.corners[i + 2].position - a);
        CHECK(normal.norm() > 0);
        CHECK(normal.dot(mesh.corners[i].normal) > 0.9 * normal.norm());
        volume += a.dot(normal) / 6;
        area += normal;
    }
    CHECK(area.norm() < 1e-12);  // of a closed surface
    CHECK(volume > 0);
    CHECK((middle_of(mesh) - Vec3(1, 2, 3)).norm() < 1);
}

TEST_CASE("A replay is a glTF file as the specification has it, with y up", "[output]") {
    const ShownScene scene = shapes_on_ground();
    const PoseSpool spool = spool_of(scene, 5);
    const Glb glb(replay_glb(scene, spool));
    check_glb(glb);
    CHECK(glb.json["meshes"].size() == 6);
    CHECK(glb.json["nodes"].size() == 8);
    CHECK(node_named(glb, "accessor").at("mesh") == node_named(glb, "box").at("mesh"));
    CHECK(node_named(glb, "accessor").at("scale")[0] == 2.5);
    // The root turns (x, y, z) to (x, z, −y).
    const auto matrix = node_named(glb, "world").at("matrix").get<std::vector<double>>();
    CHECK(matrix == std::vector<double>{1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1});
}

TEST_CASE("A replay has the poses of all frames, and turns the short way between them", "[output]") {
    const ShownScene scene = shapes_on_ground();
    const PoseSpool spool = spool_of(scene, 5);
    const Glb glb(replay_glb(scene, spool));
    const auto& animation = glb.json.at("animations").at(0);
    CHECK(animation.at("channels").size() == 2 * 6);
    for (const auto& channel : animation["channels"]) {
        const auto& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
        const auto times = glb.numbers(sampler["input"]);
        const auto values = glb.numbers(sampler["output"]);
        REQUIRE(times.size() == 5);
        CHECK(times.back() == Approx(0.4));
        for (std::size_t k = 0; k < 5; ++k) {
            if (channel["target"]["path"] == "translation") {
                CHECK(values[3 * k + 1] == static_cast<double>(k));
                CHECK(values[3 * k + 2] == 1);
            } else if (k > 0) {
                CHECK(values[4 * k + 2] * values[4 * k - 2] + values[4 * k + 3] * values[4 * k - 1] > 0);
            }
        }
    }
    CHECK(animation.at("extras").at("contacts") == std::vector<double>{0, 1, 2, 3, 4});
}

TEST_CASE("A long replay keeps every so many frames, and the last one", "[output]") {
    const ShownScene scene = shapes_on_ground();
    const PoseSpool spool = spool_of(scene, 100);
    const Glb glb(replay_glb(scene, spool, 200));
    check_glb(glb);
    const auto times = glb.numbers(glb.json["animations"][0]["samplers"][0]["input"]);
    CHECK(times.size() <= 200 / 6 + 2);
    CHECK(times.size() >= 200 / 12);
    CHECK(times.front() == 0);
    CHECK(times.back() == Approx(9.9));
}

TEST_CASE("A still shows a replay at one time, between frames too", "[output]") {
    const ShownScene scene = shapes_on_ground();
    const PoseSpool spool = spool_of(scene, 5);
    const std::string replay = replay_glb(scene, spool);
    const double time = GENERATE(-1.0, 0.0, 0.2, 0.23, 0.4, 7.0);
    const Glb still(still_of_replay(replay, time));
    check_glb(still);
    CHECK_FALSE(still.json.contains("animations"));
    CHECK(still.binary.size() < replay.size());
    const double frame = std::clamp(10 * time, 0.0, 4.0);
    const auto& ball = node_named(still, "ball");
    CHECK(ball.at("translation")[1].get<double>() == Approx(frame).margin(1e-5));
    const auto turn = ball.at("rotation").get<std::vector<double>>();
    const double angle = 2 * std::atan2(turn[2], turn[3]);
    CHECK(std::cos(angle - 1.75 * frame) == Approx(1).margin(1e-5));
    CHECK_THROWS_WITH(still_of_replay(replay.substr(0, 100), 0), Catch::Contains("expected one that scree"));
    CHECK_THROWS_WITH(still_of_replay("", 0), Catch::Contains("found no binary glTF file"));
}

TEST_CASE("A surface is shown triangle by triangle, from its front", "[output]") {
    TriangleMesh file;
    file.vertices = {Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(0, 3, 1)};
    file.triangles = {{0, 1, 2}, {0, 2, 2}};  // the other has no area
    const ShownMesh mesh = shown_surface("sheet", file);
    REQUIRE(mesh.corners.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(mesh.corners[i].position == file.vertices[i]);
        CHECK(mesh.corners[i].normal == Vec3::UnitZ());
    }
}

TEST_CASE("A picture looks at the bodies and not at the ground, and its colours are brighter", "[output]") {
    const ShownScene scene = shapes_on_ground();
    const std::string still = still_of_replay(replay_glb(scene, spool_of(scene, 3)), 0.1);
    const StillView view = view_of_still(still);
    // At 0.1 s body i is at (i, 1, 1), the box that is twice and a half as large with them; y is up in the
    // file.
    const double last = static_cast<double>(scene.bodies.size()) - 2;
    CHECK(std::abs(view.centre.x() - 0.5 * last) < 0.2);
    CHECK(std::abs(view.centre.y() - 1) < 0.1);
    CHECK(std::abs(view.centre.z() + 1) < 0.2);
    CHECK(view.radius > 0.5 * last);
    CHECK(view.radius < 0.5 * last + 1);

    const auto brightest = [](const std::string& bytes) {
        const Glb file(bytes);
        double most = 0;
        for (const auto& material : file.json.at("materials")) {
            most = std::max(most, material.at("pbrMetallicRoughness").at("baseColorFactor")[0].get<double>());
        }
        return most;
    };
    CHECK(brightest(brightened(still, 1.2)) == Approx(1.2 * brightest(still)).epsilon(1e-6));
    CHECK(brightest(brightened(still, 10)) == 1);
    check_glb(Glb(brightened(still, 1.2)));
}
