#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/mesh/mass_properties.hpp>
#include <scree/mesh_io/describe_mesh.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;
using Catch::Matchers::Contains;

namespace {

std::string mesh(const std::string& name) {
    return std::string(SCREE_SOURCE_DIR) + "/meshes/" + name + ".obj";
}

// A body of a mesh, a tenth of its size, over a floor.
SceneDescription scene(const std::string& name, const std::string& parts,
                       const std::vector<std::string>& settings = {}) {
    return parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e9, "friction": 0.5,
                               "normal_damping": 1}},
        "law": {"normal_damping": "patch"},
        "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}},
                   "ball": {"sphere": 0.02},
                   "thing": {"mesh": ")" +
                           mesh(name) + R"(", "scale": 0.1, "parts": )" + parts + R"(}},
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "thing", "material": "rock"}],
        "end_time": 0.4})",
                       "parts.json", settings);
}

// The floor lies far below, and the body of the mesh stands.
const std::vector<std::string> held{"bodies.1.motion=fixed", "shapes.floor.half_space.offset=-1"};

std::string ell_files() {
    return "[\"" + mesh("ell_foot") + "\", \"" + mesh("ell_leg") + "\"]";
}

void run(Simulation& simulation) {
    while (simulation.tick() < simulation.times().last()) {
        const bool good = simulation.advance();
        INFO(simulation.report().message);
        REQUIRE(good);
    }
}

Quat upright() {
    return Quat(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitX()));
}

}  // namespace

TEST_CASE("A body of parts has the mass properties of its mesh, from files and decomposed", "[scenes]") {
    for (const std::string& parts : {ell_files(), std::string("\"decompose\"")}) {
        CAPTURE(parts);
        const Simulation simulation(scene("ell", parts));
        const Solid& solid = simulation.bodies()[1].solid;
        const MassProperties exact =
            mass_properties(describe_mesh(mesh("ell"), Vec3::Constant(0.1)).surface.mesh);
        CHECK(solid.volume == Approx((0.3 + 0.7 * 0.3) * 0.4 * 1e-3).epsilon(1e-6));
        CHECK(solid.volume == Approx(exact.volume).epsilon(1e-12));
        CHECK((solid.body_in_file.position - exact.centroid).norm() < 1e-12);
        CHECK((solid.inertia - exact.principal_inertia).norm() < 1e-12 * exact.principal_inertia.norm());
        CHECK(solid.parts.size() == 2);
    }
}

TEST_CASE("An L, a gear, an arch and a mug are decomposed to within a hundredth of their volume",
          "[scenes]") {
    for (const char* name : {"ell", "gear", "arch", "mug"}) {
        CAPTURE(name);
        const Simulation simulation(scene(name, "\"decompose\""));
        CHECK(simulation.bodies()[1].solid.parts.size() > 1);
        REQUIRE(simulation.notes().size() == 1);
        CHECK_THAT(simulation.notes()[0], Contains("convex parts fill"));
    }
}

TEST_CASE("Parts that do not fill the mesh are refused with the figure", "[scenes]") {
    CHECK_THROWS_WITH(Simulation(scene("ell", "[\"" + mesh("ell_foot") + "\"]")),
                      Contains("shapes.thing.mesh") && Contains("the parts fill 0.588") &&
                          Contains("expected 0.99 to 1.01"));
    CHECK_THROWS_WITH(Simulation(scene("hopper", "\"decompose\"")), Contains("not closed"));
    CHECK_THROWS_WITH(Simulation(scene("ell", "[\"no_such.obj\"]")), Contains("no_such.obj"));
}

TEST_CASE("An arch stands on its two feet, each with a friction of its own, and half of the weight",
          "[scenes]") {
    SceneDescription description = scene("arch", "\"decompose\"");
    description.bodies[1].orientation = upright();
    description.bodies[1].position.z() = 1e-9;
    Simulation simulation(description);
    run(simulation);
    CHECK(simulation.body_motion(1).velocity.norm() < 1e-6);
    double left = 0;
    double right = 0;
    for (const ContactResult& result : simulation.world().contact_results()) {
        (result.point.x() < 0 ? left : right) += result.law.normal_force;
    }
    const double weight = 2600 * simulation.bodies()[1].solid.volume * 9.81;
    CHECK(left == Approx(0.5 * weight).epsilon(1e-3));
    CHECK(right == Approx(0.5 * weight).epsilon(1e-3));
}

TEST_CASE("A ball comes to rest in a mug, which a hull would not let in", "[scenes]") {
    SceneDescription description = scene("mug", "\"decompose\"");
    std::get<MeshShape>(description.shapes.at("thing")).scale = Vec3::Constant(0.02);
    description.end_time = 1;
    description.bodies[1].position = {-0.06, -0.06, 0};
    BodyDescription ball;
    ball.shape = "ball";
    ball.material = "rock";
    ball.position = {0.003, 0.002, 0.06};
    description.bodies.push_back(ball);
    Simulation simulation(description);
    run(simulation);
    const Vec3 rest = simulation.body_motion(2).pose.position;
    CHECK(rest.z() == Approx(0.02 + 0.02).epsilon(0.01));
    CHECK(std::max(std::abs(rest.x()), std::abs(rest.y())) < 0.04);
}

TEST_CASE("A hopper's surface is ground: a ball rolls down its wall and falls out below", "[scenes]") {
    SceneDescription description = scene("hopper", "\"surface\"", held);
    BodyDescription ball;
    ball.shape = "ball";
    ball.material = "rock";
    ball.position = {0.05, 0, 0.09};
    description.bodies.push_back(ball);
    SECTION("through a gap that is too small it does not fall") {
        Simulation simulation(description);
        run(simulation);
        CHECK(simulation.body_motion(2).pose.position.z() > 0);
        CHECK(simulation.body_motion(2).pose.position.z() < 0.05);
    }
    SECTION("through one that is wide enough it does") {
        description.shapes["ball"] = Sphere{0.008};
        description.materials.at("rock").friction = 0.1;
        Simulation simulation(description);
        run(simulation);
        CHECK(simulation.body_motion(2).pose.position.z() < -0.05);
    }
}

TEST_CASE("A surface does not move by forces and fills nothing", "[scenes]") {
    CHECK_THROWS_WITH(Simulation(scene("hopper", "\"surface\"")),
                      Contains("bodies.1.motion") && Contains("a surface that is dynamic"));
}

TEST_CASE("Stones that are filled into a hopper find room within its walls", "[scenes]") {
    SceneDescription description = scene("hopper", "\"surface\"", held);
    FillDescription fill;
    fill.shape = "ball";
    fill.material = "rock";
    fill.count = 4;
    fill.low = {-0.06, -0.06, 0.05};
    fill.high = {0.06, 0.06, 0.12};
    description.fill.push_back(fill);
    Simulation simulation(description);
    CHECK(simulation.bodies().size() == 6);
}
