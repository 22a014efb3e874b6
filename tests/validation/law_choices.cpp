// Every choice of the law in whole scenes, under every stepping method.

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

using Settings = std::vector<std::string>;

constexpr double gravity = 9.81;
constexpr double mass = 2.6;  // [kg]

// A cube of 0.1 m on level ground.
const std::string crate_on_ground = R"({
    "materials": {"rock": {"density": 2600, "youngs_modulus": 1e8, "friction": 0.5}},
    "shapes": {"crate": {"box": [0.1, 0.1, 0.1]}, "floor": {"half_space": {"normal": [0, 0, 1]}}},
    "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
               {"shape": "crate", "material": "rock", "position": [0, 0, 0.05]}],
    "end_time": 0.1
})";

SceneDescription scene_with(const Settings& settings) {
    return parse_scene(crate_on_ground, "crate.json", settings);
}

// Gravity that pulls along x besides, as a multiple of its downward part.
std::string pull(double share) {
    return "gravity=[" + std::to_string(share * gravity) + ",0,-9.81]";
}

Vec3 velocity_after(Simulation& simulation, std::int64_t tick) {
    while (simulation.tick() < tick) {
        const bool good = simulation.advance();
        INFO(simulation.world().step_report().message);
        REQUIRE(good);
    }
    return simulation.body_motion(1).velocity;
}

const std::string frictions[] = {"cundall_strack", "cundall_strack_2d", "viscous"};
const std::string stiffnesses[] = {"length", "patch", "no_length"};
const std::string masses[] = {"point", "round", "exact"};

// The 27 choices of friction, each time with others of the rest.
std::vector<Settings> choices() {
    std::vector<Settings> all;
    for (const std::string& friction : frictions) {
        for (const std::string& stiffness : stiffnesses) {
            for (const std::string& reduced_mass : masses) {
                const std::size_t number = all.size();
                all.push_back(
                    {"law.friction=" + friction, "law.tangential_stiffness=" + stiffness,
                     "law.reduced_mass=" + reduced_mass,
                     number % 2 == 0 ? "law.damping=patch" : "law.damping=centroid",
                     number % 4 < 2 ? "law.normal_damping=length" : "law.normal_damping=patch",
                     number % 3 == 0 ? "law.co_rotation=false" : "law.co_rotation=true",
                     number % 5 == 0 ? "materials.rock.torsion=false" : "materials.rock.torsion=true"});
            }
        }
    }
    return all;
}

std::string joined(const Settings& settings) {
    std::string text;
    for (const std::string& setting : settings) {
        text += setting + " ";
    }
    return text;
}

}  // namespace

TEST_CASE("Under every choice and every method a block slides with the acceleration of Coulomb's law",
          "[laws]") {
    const Settings methods[] = {
        {"stepping.rtol=1e-5"},
        {R"(stepping={"method":"verlet","step":2e-5})", "materials.rock.youngs_modulus=1e7"},
        {R"(stepping={"method":"symplectic_euler","step":2e-5})", "materials.rock.youngs_modulus=1e7"}};
    for (const Settings& method : methods) {
        for (Settings settings : choices()) {
            settings.insert(settings.end(), method.begin(), method.end());
            settings.insert(settings.end(), {pull(0.8), "end_time=0.2"});
            CAPTURE(joined(settings));
            Simulation simulation(scene_with(settings));
            const Vec3 half = velocity_after(simulation, 6);
            const Vec3 end = velocity_after(simulation, 10);
            const double acceleration = (end - half).x() / (4 * 0.02);
            // Damping at the centroid leaves the block rocking from its start.
            const bool rocks = settings[3] == "law.damping=centroid";
            CHECK(std::abs(acceleration - 0.3 * gravity) < (rocks ? 1e-2 : 1e-4) * gravity);
            CHECK(std::abs(end.y()) < 1e-9);
        }
    }
}

TEST_CASE("Below μ the spring holds a block still, and viscous friction lets it creep at F over its damping",
          "[laws]") {
    for (const Settings& choice : choices()) {
        Settings settings = choice;
        settings.push_back(pull(0.3));
        settings.emplace_back("end_time=0.6");
        CAPTURE(joined(settings));
        Simulation simulation(scene_with(settings));
        const Vec3 end = velocity_after(simulation, 30);
        if (settings[0] != "law.friction=viscous") {
            CHECK(end.norm() < 1e-9);
            continue;
        }
        const PairConstants& pair = simulation.world().system().contacts[0].pair;
        CHECK(end.x() > 1e-4);
        if (settings[1] != "law.tangential_stiffness=patch" && settings[2] == "law.reduced_mass=point") {
            CHECK(end.x() == Approx(0.3 * mass * gravity / pair.tangential_damping).epsilon(1e-4));
        }
    }
}

TEST_CASE("A crate that tumbles in the x–z plane does the same under two- and three-dimensional friction",
          "[laws]") {
    const auto run = [](const std::string& friction) {
        Simulation simulation(
            scene_with({"law.friction=" + friction, "stepping.step=1e-4", "end_time=0.4",
                        "bodies.1.position=[0,0,0.12]", "bodies.1.orientation=[1,0,0.3,0]",
                        "bodies.1.velocity=[1,0,-0.5]", "bodies.1.angular_velocity=[0,6,0]"}));
        velocity_after(simulation, 20);
        CHECK(simulation.world().step_report().energy.lost_friction > 0.1);  // [J]: it did touch
        return simulation.body_motion(1);
    };
    const FrameMotion two = run("cundall_strack_2d");
    const FrameMotion three = run("cundall_strack");
    CHECK((two.pose.position - three.pose.position).norm() < 1e-9);
    CHECK((two.velocity - three.velocity).norm() < 1e-8);
    CHECK(two.angular_velocity.y() == Approx(three.angular_velocity.y()).epsilon(1e-8));
    CHECK(std::abs(two.angular_velocity.y()) > 0.1);
}

TEST_CASE("Under every choice the energy that a thrown block loses is accounted for", "[laws]") {
    for (const Settings& choice : choices()) {
        Settings settings = choice;
        settings.insert(settings.end(),
                        {"bodies.1.velocity=[0.5,0,-0.3]", "bodies.1.angular_velocity=[0,2,0]",
                         "end_time=0.2", "stepping.rtol=1e-5", "stepping.atol=1e-8"});
        CAPTURE(joined(settings));
        Simulation simulation(scene_with(settings));
        velocity_after(simulation, 10);
        const EnergyLedger& energy = simulation.world().step_report().energy;
        const double thrown = 0.5 * mass * (0.25 + 0.09);
        CHECK(energy.lost_friction > 0.01 * thrown);
        CHECK(energy.lost_tangential_damping > 0);
        CHECK(energy.lost_normal_damping > 0);
        CHECK(energy.tangential_elastic >= 0);
        CHECK(std::abs(energy.residual) < 1e-3 * thrown);
    }
}

TEST_CASE("Eq. (5.18): without Lc a millimetre block saturates its friction at every step and creeps",
          "[laws]") {
    // An explicit step of a seventh of what the normal spring bears, on a slope far below μ.
    const auto run = [](const std::string& stiffness) {
        Simulation simulation(scene_with({"law.tangential_stiffness=" + stiffness, pull(0.2),
                                          "shapes.crate.box=[1e-3,1e-3,1e-3]", "bodies.1.position=[0,0,5e-4]",
                                          "materials.rock.youngs_modulus=1e7",
                                          R"(stepping={"method":"symplectic_euler","step":5e-6})",
                                          "output.every=5e-6", "end_time=0.015"}));
        velocity_after(simulation, 2000);
        const double start = simulation.body_motion(1).pose.position.x();
        std::size_t saturated = 0;
        for (std::int64_t tick = 2001; tick <= 3000; ++tick) {
            velocity_after(simulation, tick);
            saturated += simulation.world().contact_results()[0].law.state == ContactState::slip;
        }
        const double creep = (simulation.body_motion(1).pose.position.x() - start) / 0.005;  // [m/s]
        return std::pair(saturated, creep);
    };
    for (const std::string stiffness : {"length", "patch"}) {
        const auto [saturated, creep] = run(stiffness);
        CHECK(saturated == 0);
        CHECK(std::abs(creep) < 1e-12);
    }
    const auto [saturated, creep] = run("no_length");
    CHECK(saturated == 1000);
    CHECK(creep > 1e-6);
}
