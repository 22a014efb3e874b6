#include <catch2/catch.hpp>

#include <tests/support/step_case.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// A heap of random stones near one another, all pairs in contact where they overlap, on a turning plate.
StepCase heap(Random& random) {
    StepCase step;
    step.add_prescribed(make_box({2, 2, 0.1}), {{0, 0, -0.1}, Quat::Identity()}, {0.1, 0, 0}, {0, 0, 1});
    for (int i = 0; i < 8; ++i) {
        const Shape shape = i % 4 == 3 ? Shape(Sphere{0.1}) : Shape(random.polyhedron(12, 0.12));
        step.add_body(shape, {0.15 * random.vector(), random.rotation()}, random.vector(),
                      5 * random.vector());
    }
    for (int a = 0; a < 9; ++a) {
        for (int b = a + 1; b < 9; ++b) {
            step.add_contact(a, b).history.push({random.vector(), random.direction()});
        }
    }
    return step;
}

}  // namespace

TEST_CASE("Contact forces add up to zero, and so do their torques about any point", "[dynamics]") {
    Random random(231);
    for (int i = 0; i < 20; ++i) {
        const StepCase step = heap(random);
        ForcesOf<BuiltInLaw<LawParts{}>> forces({});
        StepProblem problem(step.system, forces);
        step.begin(problem, 1e-4);
        const Vec3 point = 3 * random.vector();
        Vec3 force = Vec3::Zero();
        Vec3 torque = Vec3::Zero();
        double size = 0;
        for (std::size_t b = 0; b < step.system.bodies.size(); ++b) {
            force += problem.forces()[b];
            torque +=
                problem.torques()[b] + (problem.trial()[b].pose.position - point).cross(problem.forces()[b]);
            size += problem.forces()[b].norm();
        }
        REQUIRE(size > 1);
        CHECK(force.norm() < 1e-14 * size);
        CHECK(torque.norm() < 1e-13 * size);
    }
}

TEST_CASE("Each contact acts at its centroid: its moments are arm × force plus the law's own", "[dynamics]") {
    Random random(232);
    const StepCase step = heap(random);
    ForcesOf<BuiltInLaw<LawParts{}>> forces({});
    StepProblem problem(step.system, forces);
    step.begin(problem, 1e-4);
    int with_force = 0;
    for (std::size_t i = 0; i < step.system.contacts.size(); ++i) {
        const ContactResult& result = problem.results()[i];
        if (result.law.state == ContactState::open) {
            continue;
        }
        const Contact& contact = step.system.contacts[i];
        const Vec3& centre_a = problem.trial()[static_cast<std::size_t>(contact.a.body)].pose.position;
        const Vec3& centre_b = problem.trial()[static_cast<std::size_t>(contact.b.body)].pose.position;
        const double size = result.law.force.norm();
        const Vec3 on_a = result.law.moment + (result.point - centre_a).cross(result.law.force);
        const Vec3 on_b = -result.law.moment - (result.point - centre_b).cross(result.law.force);
        CHECK((result.moment_a - on_a).norm() < 1e-13 * size);
        CHECK((result.moment_b - on_b).norm() < 1e-13 * size);
        CHECK(result.touching);
        CHECK(result.volume > 0);
        CHECK(std::abs(result.normal.dot(result.law.trial.normal) - 1) < 1e-14);
        ++with_force;
    }
    CHECK(with_force > 8);
}

TEST_CASE("Forces from outside and weight come on top, and are all that acts on a free body", "[dynamics]") {
    StepCase step;
    step.add_body(Sphere{0.1}, {}, {1, 2, 3}, {0.3, 0.2, 0.1});
    step.system.bodies[0].weight = {0, 0, -9};
    step.system.bodies[0].force = {1, 0, 0};
    step.system.bodies[0].torque = {0, 0.5, 0};
    ForcesOf<BuiltInLaw<LawParts{}>> forces({});
    StepProblem problem(step.system, forces);
    const double h = 0.01;
    step.begin(problem, h);
    CHECK(problem.forces()[0] == Vec3(1, 0, -9));
    CHECK(problem.torques()[0] == Vec3(0, 0.5, 0));

    // Newton's method with this residual; then the momenta are those of the forces to rounding.
    for (int i = 0; i < 5; ++i) {
        REQUIRE(problem.factorize());
        Eigen::VectorXd correction = problem.residual();
        problem.solve(correction);
        step.u -= correction;
        problem.evaluate(step.u, Detail::derivative);
    }
    CHECK(problem.residual().norm() < 1e-14);
    std::vector<BodyState> states;
    problem.new_states(states);
    const Vec3 expected = step.system.states[0].momentum + h * Vec3(1, 0, -9);
    CHECK((states[0].momentum - expected).norm() < 1e-15 * expected.norm());
    const Vec3 turning = step.system.states[0].angular_momentum + h * Vec3(0, 0.5, 0);
    CHECK((states[0].angular_momentum - turning).norm() < 1e-15 * turning.norm());
}
