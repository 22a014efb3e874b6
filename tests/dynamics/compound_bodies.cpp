#include <catch2/catch.hpp>

#include <tests/dynamics/residual_error.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double h = 1e-3;
constexpr double depth = 1e-3;

// A table on two legs, turned in their body's frame, and a stone on the top of it.
StepCase table(Random& random) {
    StepCase step;
    step.material.friction = 0.5;
    const Pose frame{Vec3::Zero(), turned(0.3, {1, 1, 0})};
    step.add_prescribed(HalfSpace{}, frame, {0.01, 0, 0}, {0, 0.02, 0.01});
    const Pose body{{0, 0, 0.3 - depth}, turned(0.01, {1, 2, 0})};
    step.add_body(make_box({0.6, 0.4, 0.1}), frame * body, 0.2 * random.vector(), random.vector());
    step.add_body(icosahedron(0.1), frame * Pose{{0.1, 0, 0.42}, turned(0.2, {1, 0, 0})},
                  0.2 * random.vector(), random.vector());
    step.shapes.emplace_back(icosahedron(0.1));
    const Shape& leg = step.shapes.back();
    for (const double side : {-0.2, 0.2}) {
        const Pose local{{side, 0, -0.22}, rotation(random.vector())};
        step.add_contact({0, &step.shapes[0], {}}, {1, &leg, local})
            .history.push({50 * random.vector(), random.direction()});
    }
    step.add_contact(1, 2).history.push({50 * random.vector(), random.direction()});
    return step;
}

}  // namespace

TEST_CASE("Several parts of one body on one other: the Jacobian agrees with differences", "[dynamics]") {
    Random random(271);
    int all_touch = 0;
    double worst = 0;
    for (int i = 0; i < 30; ++i) {
        const StepCase step = table(random);
        ForcesOf<WholeDerivativeLaw<>> forces({{}, 0.03});
        StepProblem problem(step.system, forces);
        step.begin(problem, h);
        bool all = true;
        for (const ContactResult& result : problem.results()) {
            all = all && result.law.state != ContactState::open && result.volume > 1e-9;
        }
        if (all) {
            ++all_touch;
            worst = std::max(worst, residual_error(step, forces, h, 1, depth, 0.1).error);
        }
    }
    CHECK(all_touch > 3);
    CHECK(worst < 1e-8);
}

TEST_CASE("A part's place in its body enters as if the body's frame were elsewhere", "[dynamics]") {
    // The same cube on the ground as one body about its centre and as a part off the mass centre.
    const auto result_of = [](const Vec3& offset) {
        StepCase step;
        step.add_prescribed(HalfSpace{}, {});
        step.add_body(cube(0.2), {Vec3(0.3, 0.1, 0.1 - depth) - offset, Quat::Identity()});
        const Collider part{1, &step.shapes[1], {offset, Quat::Identity()}};
        step.add_contact({0, &step.shapes[0], {}}, part);
        ForcesOf<BuiltInLaw<LawParts{}>> forces({});
        StepProblem problem(step.system, forces);
        step.begin(problem, 0);
        return problem.results()[0];
    };
    const ContactResult centred = result_of(Vec3::Zero());
    const Vec3 offset(0.2, -0.1, 0.05);
    const ContactResult shifted = result_of(offset);
    CHECK((centred.point - shifted.point).norm() < 1e-15);
    CHECK(centred.volume == Approx(shifted.volume).epsilon(1e-12));
    const Vec3 expected = centred.moment_b + offset.cross(-centred.law.force);
    CHECK((shifted.moment_b - expected).norm() < 1e-12 * centred.law.force.norm());
}
