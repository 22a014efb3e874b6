#include <scree/scenes/friction_onset.hpp>

#include <cmath>
#include <limits>
#include <numbers>

#include <scree/mesh/mass_properties.hpp>
#include <scree/scenes/simulation.hpp>

namespace scree {

namespace {

constexpr double gravity = 9.81;  // [m/s²]
constexpr double slope = 0.2;     // tan θ: twice the pull stays below what friction can hold
constexpr double friction = 0.5;
constexpr double density = 2600;  // [kg/m³]
constexpr int steps_a_sample = 4;
const Vec3 edges(0.1, 0.1, 0.002);  // [m]: so flat that a pull at its middle does not make it rock

double characteristic_length() {
    return 2 * sphere_radius(edges.prod());
}

Vec3 pull() {
    return gravity * Vec3(slope, 0, -1).normalized();
}

double depth_at_rest(const FrictionOnset& onset) {
    const double face = onset.youngs_modulus / characteristic_length() * edges.x() * edges.y();
    return -onset_mass() * pull().z() / face;
}

}  // namespace

SceneDescription friction_onset_scene(const FrictionOnset& onset, double duration, double every) {
    SceneDescription scene;
    scene.name = "friction_onset";
    scene.gravity = pull();
    MaterialDescription& rock = scene.materials["rock"];
    rock.density = density;
    rock.youngs_modulus = onset.youngs_modulus;
    rock.friction = friction;
    rock.tangential_damping = onset.tangential_damping;
    rock.tangential_ratio = onset.tangential_ratio;
    scene.shapes["slope"] = HalfSpace{};
    scene.shapes["tile"] = BoxShape{edges};
    BodyDescription ground;
    ground.name = ground.shape = "slope";
    ground.material = "rock";
    ground.motion = FixedMotion{};
    BodyDescription tile;
    tile.name = tile.shape = "tile";
    tile.material = "rock";
    tile.position.z() = edges.z() / 2 - depth_at_rest(onset);
    scene.bodies = {ground, tile};
    static_cast<LawOptions&>(scene.law) = onset.law;
    scene.stepping.step = every / steps_a_sample;
    scene.end_time = duration;
    scene.output.every = every;
    return scene;
}

double onset_mass() {
    return density * edges.prod();
}

double onset_frequency(const FrictionOnset& onset) {
    double stiffness = onset.tangential_ratio * onset.youngs_modulus;
    switch (onset.law.tangential_stiffness) {
        case TangentialStiffness::length:
            stiffness *= characteristic_length();
            break;
        case TangentialStiffness::patch:
            stiffness *= edges.x() * edges.y() / characteristic_length();
            break;
        case TangentialStiffness::no_length:
            break;  // times one metre
    }
    return std::sqrt(stiffness / onset_mass());
}

double onset_damping_ratio(const FrictionOnset& onset) {
    return 0.5 * onset.tangential_damping;
}

double onset_spring(const FrictionOnset& onset, double time) {
    const double ratio = onset_damping_ratio(onset);
    const double phase = onset_frequency(onset) * time;
    if (ratio == 1) {
        return 1 - (1 + phase) * std::exp(-phase);
    }
    const double root = std::sqrt(std::abs(1 - ratio * ratio));
    const bool swings = ratio < 1;
    const double even = swings ? std::cos(root * phase) : std::cosh(root * phase);
    const double odd = swings ? std::sin(root * phase) : std::sinh(root * phase);
    return 1 - std::exp(-ratio * phase) * (even + ratio / root * odd);
}

OnsetRun run_friction_onset(const FrictionOnset& onset, double periods, int samples) {
    const double period = 2 * std::numbers::pi / onset_frequency(onset);
    Simulation simulation(friction_onset_scene(onset, periods * period, period / samples));
    OnsetRun run{{0}, {0}, false};
    while (simulation.tick() < simulation.times().last() && simulation.advance()) {
        const ContactForce& contact = simulation.world().contact_results()[0].law;
        run.time.push_back(simulation.time());
        // The force on the slope, which is the first of the two.
        run.spring.push_back(contact.trial.force.x() / (onset_mass() * pull().x()));
        run.slipped = run.slipped || contact.state != ContactState::stick;
    }
    return run;
}

double onset_delay(const OnsetRun& run, double share) {
    for (std::size_t i = 1; i < run.time.size(); ++i) {
        if (run.spring[i] >= share) {
            const double part = (share - run.spring[i - 1]) / (run.spring[i] - run.spring[i - 1]);
            return run.time[i - 1] + part * (run.time[i] - run.time[i - 1]);
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace scree
