// Fast spin, fast bodies against thin walls, and bodies that overlap from the start.

#include <cmath>

#include "scene_parts.hpp"
#include "stability.hpp"

namespace scree {

namespace {

/// A free brick: whatever its spin, energy and angular momentum stay.
Problem spinning_brick(double spin) {
    Problem problem = bare_problem("spin", 100 / spin, 10);
    SceneDescription& scene = problem.scene;
    scene.gravity.setZero();
    scene.shapes["brick"] = BoxShape{Vec3(0.2, 0.1, 0.05)};
    const Vec3 first = spin * Vec3(0.6, 0.3, 0.74).normalized();
    add_body(scene, "brick", Vec3::Zero()).angular_velocity = first;
    problem.quantities = {"energy", "momentum"};
    problem.observe = [first](const Simulation& simulation) {
        const Vec3 moments = simulation.bodies()[0].solid.inertia;
        const FrameMotion now = simulation.body_motion(0);
        const Vec3 spins = now.pose.orientation.conjugate() * now.angular_velocity;
        const Vec3 start = moments.cwiseProduct(first);
        const Vec3 momentum = now.pose.orientation * moments.cwiseProduct(spins);
        return Values{moments.dot(spins.cwiseAbs2()) / first.dot(start),
                      (momentum - start).norm() / start.norm()};
    };
    problem.model = [](double) { return Values{1, 0}; };
    problem.last_only = true;
    return problem;
}

/// A ball that spins on the floor is driven by μ g as long as it slips.
Problem spinning_ball(double spin) {
    constexpr double duration = 0.1;
    Problem problem = bare_problem("spin on the floor", duration, 10);
    SceneDescription& scene = problem.scene;
    scene.shapes["ball"] = Sphere{0.05};
    add_floor(scene);
    add_body(scene, "ball", Vec3(0, 0, 0.05 - 2.9e-5)).angular_velocity =
        spin * Vec3::UnitZ().cross(odd_direction());
    problem.quantities = {"speed", "drift"};
    const double last = std::min(0.5 * earth_gravity * duration, 2.0 / 7 * spin * 0.05);
    problem.observe = [last](const Simulation& simulation) {
        const Vec3 velocity = simulation.file_motion(1).velocity / last;
        return Values{velocity.dot(odd_direction()), velocity.dot(odd_direction().cross(Vec3::UnitZ()))};
    };
    problem.model = [](double) { return Values{1, 0}; };
    problem.last_only = true;
    return problem;
}

/// A cube of 0.1 m flies at a fixed wall of 1 cm: by the law it bounces.
Problem thin_wall(double speed) {
    Problem problem = bare_problem("thin wall", std::max(2 / speed, 0.05), 10);
    SceneDescription& scene = problem.scene;
    scene.gravity.setZero();
    scene.materials["rock"].youngs_modulus = 1e13;
    scene.shapes["cube"] = shipped_mesh("cube", 0.1);
    scene.shapes["wall"] = BoxShape{Vec3(0.01, 2, 2)};
    add_fixed(scene, "wall", Pose{Vec3(1, 0, 0), Quat::Identity()});
    add_body(scene, "cube", Vec3::Zero()).velocity.x() = speed;
    problem.quantities = {"through the wall"};
    problem.observe = [](const Simulation& simulation) {
        return Values{simulation.file_motion(1).pose.position.x() < 1 ? 0.0 : 2.0};
    };
    problem.model = [](double) { return Values{0}; };
    problem.last_only = true;
    return problem;
}

/// Two bodies overlap and push each other apart: no more energy comes out than was stored. What was, and what
/// became of it, is in the run's own account.
Problem overlapping(const Vec3& apart, double scale) {
    Problem problem = bare_problem("overlap", 0.02, 10);
    SceneDescription& scene = problem.scene;
    scene.gravity.setZero();
    scene.shapes["cube"] = shipped_mesh("cube", 0.1);
    scene.shapes["other"] = shipped_mesh("cube", scale);
    add_body(scene, "cube", Vec3::Zero());
    add_body(scene, "other", apart);
    problem.quantities = {"energy left unexplained", "momentum"};
    problem.observe = [](const Simulation& simulation) {
        const EnergyLedger& energy = simulation.report().energy;
        // What was stored at first is what became of it: motion and losses.
        const double stored = energy.kinetic + energy.lost_normal_damping + energy.lost_tangential_damping +
                              energy.lost_friction;
        Vec3 momentum = Vec3::Zero();
        double speeds = 1e-300;
        for (std::size_t i = 0; i < 2; ++i) {
            const Vec3 each = simulation.bodies()[i].solid.volume * simulation.body_motion(i).velocity;
            momentum += each;
            speeds += each.norm();
        }
        return Values{energy.residual / std::max(stored, 1e-300), momentum.norm() / speeds};
    };
    problem.model = [](double) { return Values{0, 0}; };
    problem.last_only = true;
    return problem;
}

}  // namespace

void add_impacts(std::vector<Extreme>& all, bool quick) {
    for (const double spin : {1.0, 1e3, 1e5}) {
        all.push_back({"spin [rad/s]", cell(spin), spinning_brick(spin)});
        if (!quick || spin > 1e3) {
            all.push_back({"spin on the floor [rad/s]", cell(spin), spinning_ball(std::max(spin, 10.0))});
        }
    }
    for (const double speed : {1.0, 1e2, 1e3, 1e4}) {
        all.push_back({"speed at a thin wall [m/s]", cell(speed), thin_wall(speed)});
    }
    for (const double part : {1e-9, 1e-6, 1e-3, 0.1, 0.9}) {
        all.push_back(
            {"overlap [size]", cell(part), overlapping(Vec3(0.1 * (1 - part), 0.013, -0.007), 0.1), 0.05});
    }
    all.push_back({"overlap [size]", "wholly inside", overlapping(Vec3(0.01, 0.005, 0), 0.04), 0.05});
    all.push_back({"overlap [size]", "coincident", overlapping(Vec3::Zero(), 0.1), 0.05});
}

}  // namespace scree
