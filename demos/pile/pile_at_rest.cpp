// The pile of a scene file, run to its end, and whether it is at rest: how fast the fastest stone is, whether
// all are inside the walls, and whether the forces on each stone balance.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

namespace {

// Largest net force on a dynamic body, over its weight.
double imbalance(const scree::DynamicsWorld& world) {
    const scree::System& system = world.system();
    std::vector<scree::Vec3> net;
    for (const scree::Body& body : system.bodies) {
        net.push_back(body.weight + body.force);
    }
    for (std::size_t i = 0; i < world.contact_results().size(); ++i) {
        const scree::ContactForce& law = world.contact_results()[i].law;
        if (law.state == scree::ContactState::open) {
            continue;
        }
        net[static_cast<std::size_t>(system.contacts[i].a.body)] += law.force;
        net[static_cast<std::size_t>(system.contacts[i].b.body)] -= law.force;
    }
    double largest = 0;
    for (std::size_t b = 0; b < net.size(); ++b) {
        const scree::Body& body = system.bodies[b];
        if (body.dynamic()) {
            largest = std::max(largest, net[b].norm() / body.weight.norm());
        }
    }
    return largest;
}

double fastest(const scree::Simulation& simulation) {
    double speed = 0;
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
        speed = std::max(speed, simulation.body_motion(b).velocity.norm());
    }
    return speed;
}

// How far the mass centre of any stone is beyond a half-space that should hold it; negative: all are inside.
double outside(const scree::Simulation& simulation) {
    double farthest = -1;
    for (std::size_t w = 0; w < simulation.bodies().size(); ++w) {
        const auto* wall = std::get_if<scree::HalfSpace>(simulation.bodies()[w].solid.shape.get());
        if (wall == nullptr) {
            continue;
        }
        const scree::Pose pose = simulation.body_motion(w).pose;
        for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
            if (!simulation.bodies()[b].dynamic()) {
                continue;
            }
            const scree::Vec3 inside = pose.inverse() * simulation.body_motion(b).pose.position;
            farthest = std::max(farthest, wall->offset - wall->normal.dot(inside));
        }
    }
    return farthest;
}

// Runs to the end and says every tenth of the time how it is getting on.
void settle(scree::Simulation& simulation) {
    const auto start = std::chrono::steady_clock::now();
    std::printf("%8s %8s %10s %12s %14s %12s\n", "time [s]", "steps", "contacts", "its/step", "fastest [m/s]",
                "wall [s]");
    std::size_t steps = 0;
    std::size_t iterations = 0;
    const std::int64_t tenth = std::max<std::int64_t>(1, simulation.times().last() / 10);
    while (simulation.tick() < simulation.times().last() && simulation.advance()) {
        if (simulation.tick() % tenth != 0) {
            continue;
        }
        const scree::StepReport& report = simulation.report();
        const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        std::printf("%8.2f %8zu %10zu %12.2f %14.2e %12.1f\n", simulation.time(), report.steps.accepted,
                    report.contacts,
                    static_cast<double>(report.steps.newton.iterations - iterations) /
                        static_cast<double>(std::max<std::size_t>(1, report.steps.accepted - steps)),
                    fastest(simulation), wall);
        std::fflush(stdout);
        steps = report.steps.accepted;
        iterations = report.steps.newton.iterations;
    }
}

// Whether the stones rest, forces balance and none has got out.
bool judge(const scree::Simulation& simulation) {
    const scree::StepReport& report = simulation.report();
    const double speed = fastest(simulation);
    const double balance = imbalance(simulation.world());
    const double beyond = outside(simulation);
    std::printf("\nfastest stone %.1e m/s, largest net force %.1e of a weight, %s, energy residual %.1e J\n",
                speed, balance, beyond < 0 ? "all inside" : "NOT all inside", report.energy.residual);
    if (report.failed) {
        std::printf("stopped: %s\n", report.message.c_str());
    }
    return !report.failed && speed < 1e-5 && balance < 1e-3 && beyond < 0;
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path file =
        argc > 1 ? argv[1] : std::filesystem::path(SCREE_SOURCE_DIR) / "demos/pile/scene.json";
    scree::Simulation simulation(scree::read_scene(file));
    settle(simulation);
    return judge(simulation) ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const std::exception& error) {
    std::fprintf(stderr, "pile_at_rest: %s\n", error.what());
    return 2;
}
