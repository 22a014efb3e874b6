#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <tests/support/explicit_motion.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double edge = 0.1;
constexpr double gravity = 9.81;

// A frictionless cube at rest on the ground, then tilted a little about a horizontal axis.
struct Rocking {
    StepCase step;
    double face_stiffness, mass;

    explicit Rocking(double normal_damping) {
        step.material = {1e8, 0, normal_damping, 0, 2.0 / 7, true};
        step.add_prescribed(HalfSpace{}, {});
        step.add_body(cube(edge), {});
        Body& body = step.system.bodies[1];
        mass = body.mass;
        body.inertia = Vec3::Constant(mass * edge * edge / 6);
        body.weight = {0, 0, -mass * gravity};
        step.add_contact(0, 1);
        face_stiffness = step.system.contacts[0].pair.elastic * edge * edge;
        const double sunk = mass * gravity / face_stiffness;
        step.system.states[1].position = {0, 0, edge / 2 - sunk};
        step.system.states[1].orientation = turned(0.3 * sunk / (edge / 2), Vec3::UnitX());
    }
    [[nodiscard]] double tilt() const { return 2 * step.system.states[1].orientation.x(); }
};

// The tilt's amplitude after so many of its periods over the first one.
double amplitude_ratio(Rocking& rocking, ContactForces& forces, int periods) {
    // Rotation about the mass centre: the face's own stiffness, less the weight's lever.
    const double stiffness = rocking.face_stiffness * edge * edge / 12 - rocking.mass * gravity * edge / 2;
    const double frequency = std::sqrt(stiffness / (rocking.mass * edge * edge / 6));
    const double h = 2 * std::numbers::pi / frequency / 200;
    ExplicitMotion motion(rocking.step, forces);
    const double first = rocking.tilt();
    double last = 0;
    for (int i = 0; i < 200 * periods + 20; ++i) {
        motion.advance(h);
        if (i > 200 * periods - 20) {
            last = std::max(last, rocking.tilt());  // near the whole number of periods
        }
    }
    return last / first;
}

}  // namespace

TEST_CASE("A frictionless cube's rocking dies out with ζ_θ = ζ ω_θ/ω_n", "[dynamics]") {
    for (const double damping : {0.05, 0.2}) {
        Rocking rocking(damping);
        const double length = rocking.step.system.contacts[0].pair.length;
        const double ratio =
            damping * edge / (2 * length) / std::sqrt(2.0);  // ω_θ² = k a²/12 / (m a²/6) = ω_n²/2
        ForcesOf<BuiltInLaw<LawParts{}>> forces({});
        const double left = amplitude_ratio(rocking, forces, 4);
        const double decay = -std::log(left) / (2 * std::numbers::pi * 4);
        CHECK(decay * std::sqrt(1 - ratio * ratio) == Approx(ratio).epsilon(0.02));
    }
}

TEST_CASE("Damping at the centroid does not damp rocking", "[dynamics]") {
    Rocking rocking(0.2);
    ForcesOf<BuiltInLaw<LawParts{}>> forces({{.damping = DampingPlace::centroid}});
    CHECK(amplitude_ratio(rocking, forces, 4) == Approx(1).epsilon(1e-2));
}

TEST_CASE("Undamped and frictionless, a stone that bounces and tumbles on a half-space keeps its energy",
          "[dynamics]") {
    Random random(251);
    for (int i = 0; i < 3; ++i) {
        StepCase step;
        step.material = {1e6, 0, 0, 0, 2.0 / 7, true};
        step.add_prescribed(HalfSpace{}, {});
        step.add_body(random.polyhedron(12, edge), {{0, 0, 1.2 * edge}, random.rotation()}, {0.5, 0, -1},
                      10 * random.vector());
        Body& body = step.system.bodies[1];
        body.weight = {0, 0, -body.mass * gravity};
        step.add_contact(0, 1);
        ForcesOf<BuiltInLaw<LawParts{}>> forces({});
        ExplicitMotion motion(step, forces);
        double least_elastic = 0;
        const auto energy = [&] {
            const ContactResult& result = motion.evaluate().results()[0];
            const double elastic = result.touching ? result.law.normal_energy : 0;
            least_elastic = std::max(least_elastic, elastic);
            const BodyState& state = step.system.states[1];
            return elastic - body.weight.dot(state.position) +
                   0.5 * state.momentum.dot(velocity(body, state)) +
                   0.5 * state.angular_momentum.dot(spin(body, state));
        };
        const double start = energy();
        double worst = 0;
        for (int n = 0; n < 30000; ++n) {
            motion.advance(1e-5);
            worst = std::max(worst, std::abs(energy() - start));
        }
        CHECK(least_elastic > 0.2 * start);  // it did bounce
        CHECK(worst < 1e-7 * start);         // of the explicit steps, through changes of the touching corners
    }
}
