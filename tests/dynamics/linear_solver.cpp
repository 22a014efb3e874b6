#include <catch2/catch.hpp>

#include <tests/support/step_case.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double edge = 0.1;
constexpr double depth = 1e-5;

// Boxes in a row, each a little into the next, with random velocities.
StepCase chain(Random& random, int boxes) {
    StepCase step;
    for (int i = 0; i < boxes; ++i) {
        const Pose pose{{0, 0, (edge - depth) * i}, rotation(1e-5 * random.vector())};
        step.add_body(cube(edge), pose, 1e-3 * random.vector(), 1e-2 * random.vector());
    }
    for (int i = 0; i + 1 < boxes; ++i) {
        step.add_contact(i, i + 1).history.push({random.vector(), Vec3::UnitZ()});
    }
    return step;
}

// What the solution for a random right side leaves of it, relative to it.
double unsolved(StepProblem& problem, Random& random, std::size_t bodies) {
    Eigen::VectorXd right(static_cast<Eigen::Index>(6 * bodies));
    for (double& value : right) {
        value = random.uniform(-1, 1);
    }
    Eigen::VectorXd x = right;
    REQUIRE(problem.solve(x));
    return (problem.jacobian().dense() * x - right).norm() / right.norm();
}

// The accuracy of the iteration; the boxes' rows weigh differently in mass and in moment of inertia.
constexpr double accurate = 1e-5;

}  // namespace

TEST_CASE("Few bodies by a dense factorisation and many by iteration: both solve the whole matrix",
          "[dynamics]") {
    Random random(241);
    for (const int boxes : {1, 2, 5, 8, 9, 12, 30}) {
        const StepCase step = chain(random, boxes);
        ForcesOf<BuiltInLaw<LawParts{}>> forces({});
        StepProblem problem(step.system, forces);
        step.begin(problem, 1e-3);
        REQUIRE(problem.factorize());
        CHECK(unsolved(problem, random, static_cast<std::size_t>(boxes)) < (boxes <= 8 ? 1e-11 : accurate));
    }
}

TEST_CASE("Refactorising with the same and with other contacts stays right", "[dynamics]") {
    Random random(242);
    StepCase step = chain(random, 12);
    ForcesOf<BuiltInLaw<LawParts{}>> forces({});
    StepProblem problem(step.system, forces);
    step.begin(problem, 1e-3);
    REQUIRE(problem.factorize());
    CHECK_FALSE(problem.states_changed());
    step.u *= 0.5;
    problem.evaluate(step.u, Detail::derivative);
    REQUIRE(problem.factorize());
    CHECK(unsolved(problem, random, 12) < accurate);
    // The seventh box flies off upwards with all above it.
    for (Eigen::Index b = 7; b < 12; ++b) {
        step.u(6 * b + 2) += 1;
    }
    problem.evaluate(step.u, Detail::derivative);
    CHECK(problem.states_changed());
    REQUIRE(problem.factorize());
    CHECK(unsolved(problem, random, 12) < accurate);
    // And comes back.
    step.begin(problem, 1e-3);
    for (Eigen::Index b = 7; b < 12; ++b) {
        step.u(6 * b + 2) -= 1;
    }
    problem.evaluate(step.u, Detail::derivative);
    REQUIRE(problem.factorize());
    CHECK(unsolved(problem, random, 12) < accurate);
}

TEST_CASE("A fixed body's part of the solution is zero", "[dynamics]") {
    Random random(243);
    StepCase step;
    step.add_prescribed(HalfSpace{}, {});
    step.add_body(cube(edge), {{0, 0, edge / 2 - depth}, Quat::Identity()});
    step.add_contact(0, 1);
    ForcesOf<BuiltInLaw<LawParts{}>> forces({});
    StepProblem problem(step.system, forces);
    step.begin(problem, 1e-3);
    REQUIRE(problem.factorize());
    Eigen::VectorXd x = Eigen::VectorXd::Ones(12);
    problem.solve(x);
    CHECK(x.head<6>().norm() == 0);
    const Eigen::MatrixXd block = problem.jacobian().dense().bottomRightCorner<6, 6>();
    CHECK((block * x.tail<6>() - Eigen::VectorXd::Ones(6)).norm() < 1e-12);
}

TEST_CASE("A matrix that is not finite is reported, for few bodies and for many", "[dynamics]") {
    for (const int boxes : {2, 12}) {
        Random random(244);
        StepCase step = chain(random, boxes);
        ForcesOf<BuiltInLaw<LawParts{}>> forces({});
        StepProblem problem(step.system, forces);
        step.begin(problem, 1e-3);
        step.system.bodies[1].inertia.x() = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(problem.factorize());
    }
}
