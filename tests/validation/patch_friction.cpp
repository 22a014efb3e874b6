// Bodies that spin on a face, against closed forms.

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/scenes/find_scene.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

using Settings = std::vector<std::string>;

constexpr double radius = 0.1;

const Settings explicit_methods[] = {
    {R"(stepping={"method":"verlet","step":2e-5})", "materials.rock.youngs_modulus=1e7"},
    {R"(stepping={"method":"symplectic_euler","step":2e-5})", "materials.rock.youngs_modulus=1e7"}};

void advance(Simulation& simulation, std::int64_t ticks) {
    for (std::int64_t i = 0; i < ticks; ++i) {
        const bool good = simulation.advance();
        INFO(simulation.report().message);
        REQUIRE(good);
    }
}

struct Sample {
    double speed, turning;  // v and R ω [m/s]
    [[nodiscard]] double ratio() const { return speed / turning; }
};

// The disc's motion until it spins with some thousandths of what it had: the ratio nears its end as the root
// of that.
std::vector<Sample> disc(const std::string& torsion, double speed, double turning,
                         const Settings& more = {}) {
    Settings settings{"materials.rock.torsion=" + torsion, "output.every=0.0001",
                      "materials.rock.youngs_modulus=1e11"};
    settings.insert(settings.end(), more.begin(), more.end());
    SceneDescription scene = read_scene(find_scene("spinning_disc"), settings);
    scene.bodies[1].velocity = {speed, 0, 0};
    scene.bodies[1].angular_velocity = {0, 0, turning / radius};
    Simulation simulation(scene);
    std::vector<Sample> samples;
    do {
        const FrameMotion motion = simulation.body_motion(1);
        samples.push_back({motion.velocity.norm(), radius * motion.angular_velocity.z()});
        advance(simulation, 1);
    } while (samples.back().turning > 0.003 * turning && simulation.tick() < simulation.times().last());
    samples.pop_back();
    return samples;
}

// When a cube that spins at 5 rad/s stands still [s], by what it has left after most of the time.
double stopping_time(const std::string& torsion, const Settings& more = {}) {
    Settings settings{"stepping.rtol=1e-5", "materials.rock.torsion=" + torsion};
    settings.insert(settings.end(), more.begin(), more.end());
    Simulation simulation(parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e9, "friction": 0.5}},
        "shapes": {"crate": {"box": [0.1, 0.1, 0.1]}, "floor": {"half_space": {"normal": [0, 0, 1]}}},
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "crate", "material": "rock", "position": [0, 0, 0.05],
                    "angular_velocity": [0, 0, 5]}],
        "end_time": 0.1, "output": {"every": 0.002}})",
                                      "cube.json", settings));
    advance(simulation, 20);
    const double left = simulation.body_motion(1).angular_velocity.z();
    advance(simulation, 30);
    // An explicit method leaves the springs swinging for a while.
    CHECK(std::abs(simulation.body_motion(1).angular_velocity.z()) < (more.empty() ? 1e-6 : 0.01));
    return 0.04 * 5 / (5 - left);
}

}  // namespace

TEST_CASE("A disc that slides and spins stops both at v/(Rω) = 0.653 with friction on cells", "[laws]") {
    for (const double speed : {0.55, 0.6, 0.75}) {
        const std::vector<Sample> samples = disc("patch", speed, 1);
        CAPTURE(speed, samples.size());
        CHECK(samples.back().ratio() == Approx(0.653).epsilon(0.01));
    }
}

TEST_CASE("Under the limit surface the same disc has v ∝ ω^(9/8)", "[laws]") {
    for (const double speed : {0.5, 1.0}) {
        const std::vector<Sample> samples = disc("true", speed, 1);
        CAPTURE(speed, samples.size());
        const Sample& first = samples[samples.size() / 10];
        const Sample& last = samples.back();
        const double power = std::log(last.speed / first.speed) / std::log(last.turning / first.turning);
        CHECK(power == Approx(9.0 / 8).epsilon(0.01));
    }
}

TEST_CASE("Explicit methods stop the disc at the same ratio", "[laws]") {
    for (const Settings& method : explicit_methods) {
        CAPTURE(method[0]);
        CHECK(disc("patch", 0.65, 1, method).back().ratio() == Approx(0.653).epsilon(0.02));
    }
}

TEST_CASE("A cube of 0.1 m that spins at 5 rad/s stops after 44.4 ms, on cells and on the limit surface",
          "[laws]") {
    const double expected = 0.1 * 5 / (6 * 0.5 * 9.81 * 0.38260);  // a ω a/(6 μ g r̄)
    for (const char* torsion : {"\"patch\"", "true"}) {
        CAPTURE(torsion);
        CHECK(stopping_time(torsion) == Approx(expected).epsilon(5e-3));
    }
    for (const Settings& method : explicit_methods) {
        CAPTURE(method[0]);
        CHECK(stopping_time("\"patch\"", method) == Approx(expected).epsilon(0.01));
    }
}

TEST_CASE("A tile on a slope with friction on cells neither creeps nor turns below atan μ, and slides above",
          "[laws]") {
    const auto scene = [](double tangent, double heading) {
        SceneDescription description = parse_scene(R"({
            "materials": {"rock": {"density": 2600, "youngs_modulus": 1e9, "friction": 0.5,
                                   "torsion": "patch"}},
            "shapes": {"tile": {"box": [0.13, 0.09, 0.02]}, "floor": {"half_space": {"normal": [0, 0, 1]}}},
            "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                       {"shape": "tile", "material": "rock", "position": [0, 0, 0.01]}],
            "end_time": 1})",
                                                   "slope.json");
        description.gravity =
            9.81 * Vec3(tangent * std::cos(heading), tangent * std::sin(heading), -1).normalized();
        return description;
    };
    for (const double heading : {0.0, 0.6}) {
        CAPTURE(heading);
        Simulation still(scene(0.48, heading));
        advance(still, 10);
        const FrameMotion start = still.body_motion(1);
        advance(still, 40);
        const FrameMotion end = still.body_motion(1);
        CHECK((end.pose.position - start.pose.position).norm() < 1e-9);
        CHECK(end.pose.orientation.angularDistance(start.pose.orientation) < 1e-7);
        Simulation slides(scene(0.7, heading));
        advance(slides, 10);
        const double before = slides.body_motion(1).velocity.norm();
        advance(slides, 10);
        const double expected = 9.81 * (0.7 - 0.5) / std::hypot(1, 0.7);
        CHECK((slides.body_motion(1).velocity.norm() - before) / 0.2 == Approx(expected).epsilon(1e-3));
    }
}
