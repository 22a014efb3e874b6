// What a contact costs with a law of one's own, against the built-in one: nanoseconds of processor time per
// evaluation, overlap and all, as the median of several repetitions. A law that gives its derivative costs
// what the built-in one does, for it is the same code; one that gives none is asked nine times more where
// Newton wants the derivative.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

#include <demos/cohesion/sintering_law.hpp>
#include <demos/hertz_mindlin/elastic_spheres_law.hpp>
#include <tests/support/step_case.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr int contacts = 256;
constexpr int rounds = 40;
constexpr int repetitions = 15;

struct SameWithoutDerivative {
    BuiltInLaw<LawParts{}> law;
    void operator()(const ContactInput& in, ContactForce& out) const { law(in, out); }
};

struct ThroughFunction {
    static constexpr bool gives_rates = true;
    static constexpr bool gives_power = true;
    std::function<void(const ContactInput&, ContactForce&)> law = BuiltInLaw<LawParts{}>{};
    void operator()(const ContactInput& in, ContactForce& out) const { law(in, out); }
};

// As many bodies of a shape on a half-space, a thousandth of their size deep, askew.
StepCase bodies_on_ground(const Shape& shape) {
    Random random(3);
    StepCase step;
    for (int i = 0; i < contacts; ++i) {
        const Quat turn = random.rotation();
        const double low = reach_along(shape, turn.conjugate() * -Vec3::UnitZ());
        step.add_body(shape, {Vec3(3.0 * i, 0, low - 1e-3), turn}, Vec3(1e-3, 2e-3, 0), Vec3(0, 0.01, 0));
    }
    const int ground = step.add_prescribed(HalfSpace{}, {});
    for (int i = 0; i < ground; ++i) {
        step.add_contact(i, ground).history.push({Vec3(0.1, 0.2, 0), Vec3::UnitZ(), 1e6});
    }
    return step;
}

double nanoseconds(const StepCase& step, const ContactForces& forces, Detail detail) {
    StepProblem problem(step.system, forces);
    step.begin(problem, 1e-5, 1, detail);
    std::vector<ContactResult> results(step.system.contacts.size());
    std::vector<double> times;
    for (int r = 0; r < repetitions; ++r) {
        const std::clock_t start = std::clock();
        for (int i = 0; i < rounds; ++i) {
            forces.evaluate(step.system.contacts, problem.trial(), problem.formulas(), detail, results);
        }
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        times.push_back(1e9 * seconds / (rounds * contacts));
    }
    std::nth_element(times.begin(), times.begin() + repetitions / 2, times.end());
    return times[repetitions / 2];
}

template <ContactLaw Law>
void row(const char* name, const StepCase& step, Law law) {
    const ForcesOf<Law> forces(std::move(law));
    std::printf("%-44s %10.0f %16.0f\n", name, nanoseconds(step, forces, Detail::force),
                nanoseconds(step, forces, Detail::derivative));
}

}  // namespace

int main() {
    std::printf("%-44s %10s %16s\n", "[ns]", "force", "and derivative");
    const StepCase stones = bodies_on_ground(icosahedron(1));
    row("icosahedra: the built-in law", stones, BuiltInLaw<LawParts{}>{});
    row("icosahedra: the same through std::function", stones, ThroughFunction{});
    row("icosahedra: the same, its derivative kept back", stones, SameWithoutDerivative{});
    row("icosahedra: sintering, a history of its own", stones, SinteringLaw{});
    const StepCase balls = bodies_on_ground(Sphere{1});
    row("spheres: the built-in law", balls, BuiltInLaw<LawParts{}>{});
    row("spheres: Hertz and Mindlin, no derivative", balls, ElasticSpheres{});
}
