// Bodies that move as prescribed and what they do to others, against closed forms.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

constexpr double gravity = 9.81;
constexpr double pi = std::numbers::pi;
constexpr double friction = 0.5;
constexpr double mass = 1;    // [kg], of the crate and of the ball
constexpr double edge = 0.1;  // [m], of the crate
constexpr double radius = 0.05;

// A machine, a half-space, that carries a crate of 1 kg, or a ball of 1 kg beside it.
const std::string machine = R"({
    "materials": {
        "rock": {"density": 1000, "youngs_modulus": 1e9, "friction": 0.5},
        "lead": {"density": 1909.8593171027442, "youngs_modulus": 1e9, "friction": 0.5}
    },
    "shapes": {
        "plane": {"half_space": {"normal": [0, 0, 1]}},
        "crate": {"box": [0.1, 0.1, 0.1]},
        "ball": {"sphere": 0.05}
    },
    "bodies": [
        {"name": "machine", "shape": "plane", "material": "rock", "motion": {}},
        {"name": "load", "shape": "crate", "material": "rock", "position": [0, 0, 0.05]}
    ],
    "end_time": 0.3
})";
const std::string ball = "bodies.1={\"shape\":\"ball\",\"material\":\"lead\",\"position\":[0,0,0.05]}";

// Tolerances well below those of the checks; the two explicit methods, with the softer rock and the step that
// they need.
const std::vector<std::string> implicit = {"stepping.rtol=1e-5"};
const std::vector<std::string> verlet = {"stepping={\"method\":\"verlet\",\"step\":2e-5}",
                                         "materials.rock.youngs_modulus=1e7"};
const std::vector<std::string> euler = {"stepping={\"method\":\"symplectic_euler\",\"step\":2e-5}",
                                        "materials.rock.youngs_modulus=1e7"};

Simulation simulation_of(std::vector<std::string> settings,
                         const std::vector<std::string>& method = implicit) {
    settings.insert(settings.end(), method.begin(), method.end());
    return Simulation(parse_scene(machine, "machine.json", settings));
}

void run(Simulation& simulation) {
    while (simulation.tick() < simulation.times().last()) {
        const bool good = simulation.advance();
        INFO(simulation.world().step_report().message);
        REQUIRE(good);
    }
}

double lost(const EnergyLedger& energy) {
    return energy.lost();
}

}  // namespace

TEST_CASE("A conveyor's work is the load's kinetic energy and as much again lost to friction") {
    const auto& method = GENERATE(from_range(std::vector{implicit, verlet, euler}));
    const Vec3 belt(0.3, -0.4, 0);
    Simulation simulation = simulation_of({"bodies.0.motion.surface_velocity=[0.3,-0.4,0.2]"}, method);
    run(simulation);
    // Carried along from u/(μg) on, by a force μmg all that time: work m u². The belt's part across the
    // contact counts for nothing.
    const EnergyLedger& energy = simulation.world().step_report().energy;
    CHECK((simulation.file_motion(1).velocity - belt).norm() < 1e-3 * belt.norm());
    CHECK(energy.kinetic == Approx(0.5 * mass * belt.squaredNorm()).epsilon(2e-3));
    CHECK(lost(energy) == Approx(0.5 * mass * belt.squaredNorm()).epsilon(2e-3));
    CHECK(energy.work_applied == Approx(mass * belt.squaredNorm()).epsilon(2e-3));
    CHECK(std::abs(energy.residual) < 1e-3 * energy.work_applied);
    // The load slides back by u²/(2μg) on the belt.
    const double ahead = 0.3 * belt.norm() - belt.squaredNorm() / (2 * friction * gravity);
    CHECK((simulation.file_motion(1).pose.position - Vec3(0, 0, 0.05) - ahead * belt.normalized()).norm() <
          1e-3 * ahead);
    CHECK(simulation.file_motion(0).pose.position == Vec3::Zero());
}

TEST_CASE("A ball on a conveyor rolls at two sevenths of its speed, for a seventh of m u² lost") {
    // So stiff that it sinks in by 2.5e-6 m, a rigid ball's arm but for 5e-5 of it.
    Simulation simulation =
        simulation_of({ball, "bodies.0.motion.surface_velocity=[0.5,0,0]",
                       "materials.rock.youngs_modulus=1e12", "materials.lead.youngs_modulus=1e12"});
    run(simulation);
    const EnergyLedger& energy = simulation.world().step_report().energy;
    CHECK(simulation.file_motion(1).velocity.x() == Approx(2.0 / 7 * 0.5).epsilon(1e-3));
    CHECK(simulation.file_motion(1).angular_velocity.y() == Approx(-5.0 / 7 * 0.5 / radius).epsilon(1e-3));
    CHECK(energy.kinetic == Approx(mass * 0.25 / 7).epsilon(2e-3));
    CHECK(lost(energy) == Approx(mass * 0.25 / 7).epsilon(2e-3));
    CHECK(energy.work_applied == Approx(2 * mass * 0.25 / 7).epsilon(2e-3));
}

TEST_CASE("A plane that moves along itself drives as a conveyor of its speed does") {
    const auto& method = GENERATE(from_range(std::vector{implicit, verlet, euler}));
    Simulation belt = simulation_of({"bodies.0.motion.surface_velocity=[0.3,0.1,0]"}, method);
    Simulation floor = simulation_of({"bodies.0.motion.velocity=[0.3,0.1,0]"}, method);
    run(belt);
    run(floor);
    CHECK((belt.file_motion(1).pose.position - floor.file_motion(1).pose.position).norm() < 1e-9);
    CHECK((belt.file_motion(1).velocity - floor.file_motion(1).velocity).norm() < 1e-9);
    CHECK(belt.world().step_report().energy.work_applied ==
          Approx(floor.world().step_report().energy.work_applied).epsilon(1e-9));
    CHECK(floor.file_motion(0).pose.position == Vec3(0.3 * 0.3, 0.3 * 0.1, 0));
}

TEST_CASE("A vibrating plate keeps its load while A(2πf)² < g") {
    const auto& method = GENERATE(from_range(std::vector{implicit, verlet, euler}));
    // 0.9 g at its strongest. The load starts with the plate, at the overlap that bears it.
    const double frequency = 10;
    const double amplitude = 0.9 * gravity / std::pow(2 * pi * frequency, 2);
    Simulation simulation = simulation_of(
        {"bodies.0.motion={\"velocity\":[0,0,1],\"frequency\":10,\"amplitude\":" + std::to_string(amplitude) +
             "}",
         "bodies.1.velocity=[0,0," + std::to_string(2 * pi * frequency * amplitude) + "]",
         "output.every=0.005"},
        method);
    double least = 1e9;
    double most = 0;
    while (simulation.tick() < simulation.times().last()) {
        REQUIRE(simulation.advance());
        const double plate = simulation.file_motion(0).pose.position.z();
        // The softer rock gives by fn Lc/(Y A), which is 2.4e-5 m at the strongest.
        CHECK(simulation.file_motion(1).pose.position.z() - plate == Approx(edge / 2).margin(2.5e-5));
        REQUIRE(simulation.world().contact_results().size() == 1);
        least = std::min(least, simulation.world().contact_results()[0].law.normal_force);
        most = std::max(most, simulation.world().contact_results()[0].law.normal_force);
    }
    // fn = m (g − A Ω² sin Ωt), at the ticks of a twentieth of the period.
    CHECK(least == Approx(0.1 * mass * gravity).epsilon(0.05));
    CHECK(most == Approx(1.9 * mass * gravity).epsilon(0.01));
}

TEST_CASE("A vibrating plate throws its load at the phase where A Ω² sin Ωt = g") {
    // Y = 10⁹ Pa, so that the load leaves the plate within 10⁻⁷ m of where a rigid one would.
    const double frequency = 10;
    const double omega = 2 * pi * frequency;
    const double amplitude = 2 * gravity / (omega * omega);
    Simulation simulation = simulation_of(
        {"bodies.0.motion={\"velocity\":[0,0,1],\"frequency\":10,\"amplitude\":" + std::to_string(amplitude) +
             "}",
         "bodies.1.velocity=[0,0," + std::to_string(omega * amplitude) + "]", "output.every=0.001",
         "end_time=0.05"});
    const double take_off = std::asin(0.5) / omega;
    const double height = edge / 2 + amplitude * 0.5;
    const double speed = omega * amplitude * std::cos(omega * take_off);
    while (simulation.tick() < simulation.times().last()) {
        REQUIRE(simulation.advance());
        const double flight = simulation.time() - take_off;
        CAPTURE(simulation.time());
        if (flight < 0) {
            CHECK(simulation.world().step_report().contacts == 1);
        } else if (flight > 0.001) {
            CHECK(simulation.world().step_report().contacts == 0);
            const double expected = height + speed * flight - 0.5 * gravity * flight * flight;
            CHECK(simulation.file_motion(1).pose.position.z() == Approx(expected).margin(1e-4 * edge));
        }
    }
}

TEST_CASE("A turntable's work is the kinetic energy of what it spins up, and as much again lost") {
    // A torque T until the crate has the spin ω: T ω for a time Iω/T, whatever T is.
    const auto& method = GENERATE(from_range(std::vector{implicit, verlet}));
    Simulation simulation =
        simulation_of({"bodies.0.motion.angular_velocity=[0,0,5]", "bodies.0.motion.about=[0,0,7]"}, method);
    run(simulation);
    const double moment = mass * edge * edge / 6;
    const EnergyLedger& energy = simulation.world().step_report().energy;
    CHECK(simulation.file_motion(1).angular_velocity.z() == Approx(5).epsilon(1e-3));
    CHECK(energy.kinetic == Approx(0.5 * moment * 25).epsilon(2e-3));
    CHECK(lost(energy) == Approx(0.5 * moment * 25).epsilon(5e-3));
    CHECK(energy.work_applied == Approx(moment * 25).epsilon(5e-3));
    CHECK(simulation.file_motion(0).pose.orientation.angularDistance(
              Quat(Eigen::AngleAxisd(5 * 0.3, Vec3::UnitZ()))) < 1e-15);
}

TEST_CASE("A turning drum's power is the rate at which it lifts what sticks to it") {
    // A drum about the y axis; its wall starts level at the bottom, 0.5 m below the axis. A crate goes up
    // with it by 20°, less than atan 0.5, at 0.5 m less half its edge.
    const double spin = 20 * pi / 180 / 0.3;
    Simulation simulation = simulation_of(
        {"bodies.0.motion={\"angular_velocity\":[0," + std::to_string(-spin) + ",0],\"about\":[0,0,0.5]}",
         "bodies.1.velocity=[" + std::to_string(-spin * -0.45) + ",0,0]",
         "bodies.1.angular_velocity=[0," + std::to_string(-spin) + ",0]"});
    run(simulation);
    const Vec3 arm(0.45 * std::sin(spin * 0.3), 0, 0.5 - 0.45 * std::cos(spin * 0.3));
    CHECK((simulation.file_motion(1).pose.position - arm).norm() < 1e-4);
    const EnergyLedger& energy = simulation.world().step_report().energy;
    CHECK(energy.work_applied == Approx(mass * gravity * (arm.z() - 0.05)).epsilon(2e-3));
    CHECK(lost(energy) < 2e-3 * energy.work_applied);
}

TEST_CASE("A belt under a load that a wall holds does not let it sleep, for it goes on working") {
    Simulation simulation = simulation_of(
        {"shapes.wall={\"half_space\":{\"normal\":[-1,0,0],\"offset\":-0.05}}",
         "materials.ice={\"density\":900,\"youngs_modulus\":1e9,\"friction\":0}",
         "bodies=[{\"name\":\"machine\",\"shape\":\"plane\",\"material\":\"rock\",\"motion\":{\"surface_"
         "velocity\":[0.5,0,0]}},"
         "{\"name\":\"load\",\"shape\":\"crate\",\"material\":\"rock\",\"position\":[0,0,0.05]},"
         "{\"shape\":\"wall\",\"material\":\"ice\",\"motion\":\"fixed\"}]",
         "stepping.sleep=true", "end_time=3"});
    run(simulation);
    // μ m g u, all of it lost to friction.
    const double work = friction * mass * gravity * 0.5 * 3;
    const EnergyLedger& energy = simulation.report().energy;
    CHECK(simulation.file_motion(1).velocity.norm() < 1e-6);
    CHECK(energy.work_applied == Approx(work).epsilon(2e-3));
    CHECK(energy.lost_friction == Approx(work).epsilon(2e-3));
}

TEST_CASE("The ledger's residual falls with the tolerance where prescribed bodies do the work") {
    std::vector<double> residuals;
    for (const char* rtol : {"1e-2", "1e-3", "1e-4", "1e-5"}) {
        Simulation simulation =
            simulation_of({"bodies.0.motion={\"velocity\":[0.3,0,1],\"frequency\":15,\"amplitude\":0.002,"
                           "\"surface_velocity\":[0.2,0.1,0]}",
                           "materials.rock.youngs_modulus=1e6"},
                          {std::string("stepping.rtol=") + rtol});
        run(simulation);
        const EnergyLedger& energy = simulation.world().step_report().energy;
        residuals.push_back(std::abs(energy.residual) / (lost(energy) + energy.kinetic));
    }
    CAPTURE(residuals);
    CHECK(residuals[0] < 0.1);
    CHECK(residuals[3] < 0.02 * residuals[0]);
    CHECK(residuals[3] < 1e-3);
}

TEST_CASE("A piston that comes a tick's travel of many sizes hits what is in its way") {
    // 2 m a tick. A conservative contact sends the ball off at twice the piston's speed, and the work done is
    // what it has then.
    Simulation simulation =
        simulation_of({"bodies.1={\"shape\":\"ball\",\"material\":\"lead\",\"position\":[0.01,0,1]}",
                       "gravity=[0,0,0]", "materials.rock.normal_damping=0",
                       "materials.lead.normal_damping=0", "bodies.0.motion.velocity=[0,0,100]",
                       "stepping={\"method\":\"verlet\",\"step\":1e-6}", "end_time=0.02"});
    run(simulation);
    CHECK(simulation.file_motion(1).velocity.z() == Approx(200).epsilon(1e-3));
    CHECK(simulation.world().step_report().energy.work_applied == Approx(0.5 * mass * 4e4).epsilon(1e-3));
    CHECK(simulation.file_motion(0).pose.position == Vec3(0, 0, 2));
}
