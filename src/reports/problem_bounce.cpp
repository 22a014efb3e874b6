// A cube falls flat on the floor and bounces: a linear spring and dashpot that cannot pull.

#include <cmath>

#include <scree/mesh/mass_properties.hpp>
#include <scree/world/automatic_material.hpp>

#include "problem.hpp"
#include "scene_parts.hpp"

namespace scree {

namespace {

constexpr double edge = 0.1;            // [m]
constexpr double mass = 2.6;            // [kg]
constexpr double drop = 0.05;           // [m], above the floor
constexpr double ratio = 0.1;           // ζ
constexpr double youngs_modulus = 1e7;  // [Pa]

double length() {
    return 2 * sphere_radius(edge * edge * edge);
}

/// ω of the cube on its face, √(Y A/(Lc m)).
double frequency() {
    return std::sqrt(youngs_modulus * edge * edge / (length() * mass));
}

/// Height above the floor [m] and velocity upwards [m/s].
struct Flight {
    double height = 0;
    double velocity = 0;
};

Flight free_flight(const Flight& start, double time) {
    return {start.height + (start.velocity - earth_gravity * time / 2) * time,
            start.velocity - earth_gravity * time};
}

/// When it comes down to the floor [s].
double touch_down(const Flight& start) {
    return (start.velocity + std::sqrt(start.velocity * start.velocity + 2 * earth_gravity * start.height)) /
           earth_gravity;
}

/// In touch from the floor's level on: a damped oscillator about the depth at which it would rest.
Flight in_touch(double arrival, double time) {
    const double rest = -earth_gravity / (frequency() * frequency());
    const double damping = ratio * frequency();
    const double swing = frequency() * std::sqrt(1 - ratio * ratio);
    const double even = -rest;
    const double odd = (arrival + damping * even) / swing;
    const double decay = std::exp(-damping * time);
    const double cosine = std::cos(swing * time);
    const double sine = std::sin(swing * time);
    const double value = decay * (even * cosine + odd * sine);
    return {rest + value, -damping * value + decay * swing * (odd * cosine - even * sine)};
}

/// The time in touch [s]: until spring and dashpot would pull.
double release(double arrival) {
    const auto pushes = [&](double time) {
        const Flight now = in_touch(arrival, time);
        return -frequency() * frequency() * now.height - 2 * ratio * frequency() * now.velocity > 0;
    };
    double low = 0.1 / frequency();
    double high = 4 / frequency();
    for (int i = 0; i < 200; ++i) {
        (pushes(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    }
    return low;
}

Values soft(double time) {
    Flight now{drop, 0};
    while (true) {
        const double down = touch_down(now);
        if (time <= down) {
            return {free_flight(now, time).height / drop};
        }
        time -= down;
        const double arrival = free_flight(now, down).velocity;
        const double touching = release(arrival);
        if (time <= touching) {
            return {in_touch(arrival, time).height / drop};
        }
        time -= touching;
        now = in_touch(arrival, touching);
    }
}

Values rigid(double time) {
    Flight now{drop, 0};
    while (time > touch_down(now)) {
        const double down = touch_down(now);
        time -= down;
        now = {0, -restitution(ratio) * free_flight(now, down).velocity};
    }
    return {free_flight(now, time).height / drop};
}

Values observe(const Simulation& simulation) {
    return {(simulation.file_motion(1).pose.position.z() - edge / 2) / drop};
}

}  // namespace

Problem bounce_problem() {
    Problem problem = bare_problem("bounce", 0.4, 8);
    problem.purpose =
        "A cube of 0.1 m falls flat from 0.05 m and bounces three times; on its face the law is a linear "
        "spring and dashpot, here of damping ratio 0.1, which rigid bodies have as a restitution of 0.73. "
        "The error is the largest difference in height at eight times, over the height of the fall.";
    SceneDescription& scene = problem.scene;
    MaterialDescription& rock = scene.materials["rock"];
    rock.youngs_modulus = youngs_modulus;
    rock.normal_damping = 2 * length() * ratio / edge;
    scene.shapes["cube"] = shipped_mesh("cube", edge);
    add_floor(scene);
    add_body(scene, "cube", Vec3(0, 0, edge / 2 + drop));
    problem.quantities = {"height"};
    problem.observe = observe;
    problem.rigid = rigid;
    problem.model = soft;
    return problem;
}

}  // namespace scree
