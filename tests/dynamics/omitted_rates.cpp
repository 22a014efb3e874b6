#include <catch2/catch.hpp>

#include <tests/dynamics/residual_error.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double h = 1e-3;
constexpr double edge = 0.1;

// A tilted cube on the ground, its face wholly under: shares of what moves it by its depth.
StepCase resting(Random& random, double depth, double friction) {
    StepCase step;
    step.material.friction = friction;
    const Quat tilt = rotation(0.3 * depth / (edge / 2) * random.direction());
    const double speed = 0.1 * depth / h;
    step.add_body(cube(edge), {{0, 0, edge / 2 - depth}, tilt}, speed * random.vector(),
                  speed / (edge / 2) * random.vector());
    step.add_prescribed(HalfSpace{}, {});
    Contact& contact = step.add_contact(0, 1);
    const double force = 0.3 * contact.pair.elastic * edge * edge * depth * std::min(friction, 1.0);
    contact.history.push({force * random.vector(), Vec3::UnitZ()});
    return step;
}

template <class Law>
double worst_error(const Law& law, double depth, double friction) {
    Random random(261);
    double worst = 0;
    for (int i = 0; i < 20; ++i) {
        const StepCase step = resting(random, depth, friction);
        ForcesOf<Law> forces(law);
        worst = std::max(worst, residual_error(step, forces, h, 1, depth, edge / 2).error);
    }
    return worst;
}

}  // namespace

TEST_CASE(
    "What the Jacobian leaves out, the lever's and the damping traction's change with the patch, is small "
    "for a "
    "resting face",
    "[dynamics]") {
    for (const double friction : {0.02, 0.5, 1e6}) {
        for (const double depth : {1e-3, 1e-5}) {
            INFO("μ = " << friction << ", depth " << depth);
            const double left_out = worst_error(BuiltInLaw<LawParts{}>{}, depth, friction);
            CHECK(left_out > 1e-6);  // it is left out
            CHECK(left_out < 1e-2);  // and Newton gains two digits an iteration all the same
            // Rounding of the overlap, a share of edge/depth, limits the differences.
            CHECK(worst_error(WholeDerivativeLaw<>{{}, 0.3 * edge}, depth, friction) <
                  1e-14 * edge / depth + 1e-8);
        }
    }
}
