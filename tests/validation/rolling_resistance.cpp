// Balls and a near-round mesh with rolling resistance, against closed forms.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

using Settings = std::vector<std::string>;

constexpr double gravity = 9.81;
constexpr double resistance = 0.1;  // μ_r

// A ball sinks in and rolls about a point above its lowest one: to 10⁻⁴ of its radius where the method bears
// a stiff rock, to 10⁻² where it does not.
struct Stepping {
    Settings settings;
    double tolerance;
};
const Stepping methods[] = {
    {{"stepping.rtol=1e-5"}, 1e-3},
    {{R"(stepping={"method":"verlet","step":2e-5})", "materials.rock.youngs_modulus=1e7"}, 0.03},
    {{R"(stepping={"method":"symplectic_euler","step":2e-5})", "materials.rock.youngs_modulus=1e7"}, 0.03}};

// A ball on a slope of a tangent, gravity turned.
SceneDescription ball_on_slope(const Settings& method, double tangent) {
    SceneDescription scene = parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e11, "friction": 0.8,
                               "rolling_friction": 0.1, "normal_damping": 1}},
        "law": {"normal_damping": "patch"},
        "shapes": {"ball": {"sphere": 0.05}, "floor": {"half_space": {"normal": [0, 0, 1]}}},
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "ball", "material": "rock", "position": [0, 0, 0.05]}],
        "end_time": 1})",
                                         "ball.json", method);
    scene.gravity = gravity * Vec3(tangent, 0, -1).normalized();
    return scene;
}

void advance(Simulation& simulation, std::int64_t ticks) {
    for (std::int64_t i = 0; i < ticks; ++i) {
        const bool good = simulation.advance();
        INFO(simulation.world().step_report().message);
        REQUIRE(good);
    }
}

// The largest way from where the body is a fifth of a second after the start, in the rest of the run [m].
double creep(const SceneDescription& scene) {
    Simulation simulation(scene);
    advance(simulation, 10);
    const Vec3 start = simulation.body_motion(1).pose.position;
    double most = 0;
    while (simulation.tick() < simulation.times().last()) {
        advance(simulation, 1);
        most = std::max(most, (simulation.body_motion(1).pose.position - start).norm());
    }
    return most;
}

}  // namespace

TEST_CASE("A ball stands still on a slope below atan μ_r and rolls above it", "[laws]") {
    for (const auto& [method, tolerance] : methods) {
        CAPTURE(method[0]);
        for (const double tangent : {0.02, 0.07, 0.095}) {
            CHECK(creep(ball_on_slope(method, tangent)) < 1e-9);
        }
        CHECK(creep(ball_on_slope(method, 0.105)) > 1e-3);
    }
}

TEST_CASE("A ball rolls with 5/7 g (sin θ − μ_r cos θ)", "[laws]") {
    for (const auto& [method, tolerance] : methods) {
        for (const double tangent : {0.2, 0.5}) {
            CAPTURE(method[0], tangent);
            Simulation simulation(ball_on_slope(method, tangent));
            advance(simulation, 10);
            const double before = simulation.body_motion(1).velocity.x();
            advance(simulation, 40);
            const FrameMotion end = simulation.body_motion(1);
            const double expected = 5.0 / 7 * gravity * (tangent - resistance) / std::hypot(1, tangent);
            CHECK((end.velocity.x() - before) / 0.8 == Approx(expected).epsilon(tolerance));
            CHECK(end.angular_velocity.y() * 0.05 == Approx(end.velocity.x()).epsilon(tolerance));
        }
    }
}

TEST_CASE("A ball that rolls on level ground stops after 7 v²/(10 μ_r g), and the account says by what",
          "[laws]") {
    for (const auto& [method, tolerance] : methods) {
        CAPTURE(method[0]);
        SceneDescription scene = ball_on_slope(method, 0);
        scene.bodies[1].velocity = {0.5, 0, 0};
        scene.bodies[1].angular_velocity = {0, 10, 0};
        Simulation simulation(scene);
        advance(simulation, 50);
        const FrameMotion end = simulation.body_motion(1);
        CHECK(end.pose.position.x() == Approx(0.7 * 0.25 / (resistance * gravity)).epsilon(tolerance));
        CHECK(end.velocity.norm() < 1e-7);
        CHECK(end.angular_velocity.norm() < 1e-5);
        const EnergyLedger& energy = simulation.world().step_report().energy;
        const double mass = 2600 * 4.0 / 3 * std::numbers::pi * 0.05 * 0.05 * 0.05;
        CHECK(energy.lost_rolling == Approx(0.7 * mass * 0.25).epsilon(tolerance));
        CHECK(energy.lost_torsion == 0);
        CHECK(std::abs(energy.residual) < 2e-3 * energy.lost_rolling);
    }
}

TEST_CASE("A near-round mesh tips over its edge at tan θ = (d + μ_r Lc/2)/h instead of d/h", "[laws]") {
    // An icosahedron of edge 1 on a face: h is the inner radius and d the face's.
    const double edge = 0.06;
    const double height = (3 * std::sqrt(3.0) + std::sqrt(15.0)) / 12;
    const double inside = 1 / (2 * std::sqrt(3.0));
    const double radius = std::cbrt(3 / (4 * std::numbers::pi) * 5 * (3 + std::sqrt(5.0)) / 12);
    const std::string mesh = std::string(SCREE_SOURCE_DIR) + "/meshes/icosahedron.obj";
    const auto scene = [&](double rolling_friction, double tangent) {
        SceneDescription description = ball_on_slope({"materials.rock.friction=1.5"}, tangent);
        description.materials.at("rock").rolling_friction = rolling_friction;
        MeshShape stone;
        stone.file = mesh;
        const Simulation as_it_is([&] {
            SceneDescription unit = description;
            unit.shapes["ball"] = stone;
            return unit;
        }());
        const auto& solid = std::get<ConvexPolyhedron>(*as_it_is.bodies()[1].solid.shape);
        const Plane& face = solid.planes[0];
        const double scale = edge * height / face.offset;
        stone.scale = Vec3::Constant(scale);
        description.shapes["ball"] = stone;
        const Quat turn_in_file = as_it_is.bodies()[1].solid.body_in_file.orientation;
        const Quat down = Quat::FromTwoVectors(turn_in_file * face.normal, -Vec3::UnitZ());
        // An edge of the face lies across the slope, on its lower side.
        const Vec3 first = down * (turn_in_file * solid.vertices[solid.half_edges[0].vertex]);
        const Vec3 second = down * (turn_in_file * solid.vertices[solid.half_edges[1].vertex]);
        const Vec3 middle = 0.5 * (first + second);
        const Quat about(Eigen::AngleAxisd(-std::atan2(middle.y(), middle.x()), Vec3::UnitZ()));
        description.bodies[1].orientation = about * down;
        description.bodies[1].position.z() = edge * height;
        return description;
    };
    for (const double rolling_friction : {0.0, 0.2}) {
        const double tips = (inside + rolling_friction * radius) / height;
        CAPTURE(rolling_friction, tips);
        CHECK(creep(scene(rolling_friction, 0.96 * tips)) < 1e-4);
        CHECK(creep(scene(rolling_friction, 1.04 * tips)) > 1e-2);
    }
}
