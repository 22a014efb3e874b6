// A disc that slides and spins: rigid, with even pressure and Coulomb's law at every point of its base, it
// stops both at once (Farkas, Bartels, Unger and Wolf, Phys. Rev. Lett. 90, 248302).

#include <array>
#include <cmath>
#include <numbers>

#include "disc_friction.hpp"
#include "problem.hpp"
#include "scene_parts.hpp"

namespace scree {

double disc_force(double ratio) {
    const double squares = ratio * ratio;
    if (ratio < 1e-3) {
        return ratio;
    }
    if (ratio <= 1) {
        return 4 / (3 * std::numbers::pi * ratio) *
               ((squares + 1) * std::comp_ellint_2(ratio) +
                (ratio < 1 ? (squares - 1) * std::comp_ellint_1(ratio) : 0));
    }
    return 4 / (3 * std::numbers::pi) *
           ((squares + 1) * std::comp_ellint_2(1 / ratio) - (squares - 1) * std::comp_ellint_1(1 / ratio));
}

double disc_moment(double ratio) {
    const double squares = ratio * ratio;
    if (ratio > 100) {
        return 1 / (4 * ratio);
    }
    if (ratio <= 1) {
        return 4 / (9 * std::numbers::pi) *
               ((4 - 2 * squares) * std::comp_ellint_2(ratio) +
                (ratio < 1 ? (squares - 1) * std::comp_ellint_1(ratio) : 0));
    }
    return 4 * ratio / (9 * std::numbers::pi) *
           ((4 - 2 * squares) * std::comp_ellint_2(1 / ratio) +
            (2 * squares - 5 + 3 / squares) * std::comp_ellint_1(1 / ratio));
}

namespace {

constexpr double friction = 0.5;
constexpr double radius = 0.1;    // [m]
constexpr double speed = 0.5;     // [m/s]
constexpr double first_spin = 8;  // [rad/s]

/// Way [m], turn [rad], v [m/s], ω [rad/s].
using State = std::array<double, 4>;

State rates(const State& s) {
    const double ratio = s[2] / (radius * s[3]);
    const double pull = friction * earth_gravity;
    return {s[2], s[3], -pull * disc_force(ratio), -2 * pull / radius * disc_moment(ratio)};
}

State moved(const State& s, const State& rate, double time) {
    State result = s;
    for (std::size_t i = 0; i < s.size(); ++i) {
        result[i] += time * rate[i];
    }
    return result;
}

State runge_kutta(const State& s, double step) {
    const State a = rates(s);
    const State b = rates(moved(s, a, step / 2));
    const State c = rates(moved(s, b, step / 2));
    const State d = rates(moved(s, c, step));
    State sum{};
    for (std::size_t i = 0; i < s.size(); ++i) {
        sum[i] = (a[i] + 2 * b[i] + 2 * c[i] + d[i]) / 6;
    }
    return moved(s, sum, step);
}

/// Ever smaller steps towards the stop, which is at a finite time.
Values rigid(double time) {
    State s{0, 0, speed, first_spin};
    while (time > 0 && s[3] > 1e-9 * first_spin) {
        const double step = std::min({time, 1e-4, -0.01 * s[3] / rates(s)[3]});
        s = runge_kutta(s, step);
        time -= step;
    }
    return {s[0] / radius, 0, 0, s[1]};
}

Values observe(const Simulation& simulation) {
    const FrameMotion now = simulation.file_motion(1);
    const Vec3 way = (now.pose.position - simulation.bodies()[1].start.pose.position) / radius;
    const Quat& turn = now.pose.orientation;
    return {way.dot(odd_direction()), way.dot(odd_direction().cross(Vec3::UnitZ())), way.z(),
            2 * std::atan2(turn.z(), turn.w())};
}

}  // namespace

Problem sliding_disc_problem() {
    Problem problem = bare_problem("sliding_disc", 0.25, 5);
    problem.purpose =
        "A disc of radius 0.1 m slides at 0.5 m/s and spins at 8 rad/s until friction has stopped it. By "
        "Coulomb's law at each point of its base both end at once; a contact's torsion under the limit "
        "surface is an approximation to that. The error is the largest difference in place, in radii, or in "
        "turn [rad].";
    SceneDescription& scene = problem.scene;
    scene.shapes["disc"] = shipped_mesh("disc", radius);
    add_floor(scene);
    const double area = 24 * std::sin(2 * std::numbers::pi / 48) * radius * radius;
    const double height = 0.02 * radius;
    const double depth = sunk_depth(2600 * area * height * earth_gravity, area * height, area, 1e10);
    BodyDescription& disc = add_body(scene, "disc", Vec3(0, 0, height / 2 - depth));
    disc.velocity = speed * odd_direction();
    disc.angular_velocity.z() = first_spin;
    problem.quantities = {"way", "drift", "lift", "turn"};
    problem.observe = observe;
    problem.rigid = rigid;
    problem.references = {adaptive_bdf(2, 1e-8), explicit_method(SteppingMethod::verlet, 1e-6)};
    return problem;
}

}  // namespace scree
