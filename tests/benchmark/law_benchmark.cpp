// Nanoseconds of processor time per contact, overlap included, with each switch of the law off and on.

#include <cstdio>

#include <scree/contact/hertz_mindlin.hpp>

#include <tests/benchmark/scenarios.hpp>

using namespace scree;
using namespace scree::test;

namespace {

template <class Law>
double contact_time(const Scenario& s, const PairMaterial& material, const Law& law, Detail detail) {
    StepCase step;
    step.material = material;
    for (const Pose& pose : s.poses_a) {
        step.add_body(s.a, pose, Vec3(1e-3, 2e-3, 0), Vec3(0, 0.01, 0));
    }
    const int other = step.add_prescribed(s.b, s.pose_b);
    const ForcesOf<Law> forces(law);
    for (int i = 0; i < other; ++i) {
        step.add_contact(i, other);
    }
    StepProblem problem(step.system, forces);
    step.begin(problem, 1e-9, 1, detail);
    for (std::size_t i = 0; i < step.system.contacts.size(); ++i) {
        const ContactForce& law_result = problem.results()[i].law;
        step.system.contacts[i].history.push(law_result.trial, law_result.cells);
    }
    std::vector<ContactResult> results(step.system.contacts.size());
    const std::span<const Contact> contacts(step.system.contacts);
    return nanoseconds([&](std::size_t i) {
        forces.evaluate(contacts.subspan(i, 1), problem.trial(), problem.formulas(), detail,
                        std::span(results).subspan(i, 1));
    });
}

PairMaterial rock() {
    return {1e7, 0.5, 0.5, 0.5, 2.0 / 7, true};
}

template <class Law>
void row(const char* name, const std::vector<Scenario>& scenarios, const PairMaterial& material,
         const Law& law) {
    std::printf("%-34s", name);
    for (const Scenario& s : scenarios) {
        std::printf(" %8.0f %8.0f", contact_time(s, material, law, Detail::force),
                    contact_time(s, material, law, Detail::derivative));
    }
    std::printf("\n");
}

template <LawParts parts = LawParts{}>
void built_in(const char* name, const std::vector<Scenario>& scenarios, const PairMaterial& material,
              const LawOptions& options = {}) {
    row(name, scenarios, material, BuiltInLaw<parts>{options});
}

Scenario balls(Random& random) {
    Scenario s{"balls", Sphere{1}, Sphere{1}, {}, {}};
    for (int i = 0; i < poses; ++i) {
        s.poses_a.push_back({(2 - 1e-3) * random.direction(), random.rotation()});
    }
    return s;
}

}  // namespace

int main() {
    Random random(1);
    const std::vector<Scenario> scenarios{icosahedra(random), cubes_face_on_face(random),
                                          cube_on_half_space(random), balls(random)};
    std::printf("%-34s", "[ns], and with the derivative");
    for (const char* name : {"icosahedra", "cubes", "on ground", "balls"}) {
        std::printf(" %17s", name);
    }
    std::printf("\n");
    PairMaterial smooth = rock();
    smooth.friction = 0;
    built_in<LawParts{FrictionLaw::none, false, false}>("normal force alone", scenarios, smooth);
    built_in<LawParts{FrictionLaw::none, false, false}>("  of the potential", scenarios, smooth,
                                                        {.elasticity = Elasticity::potential});
    built_in<LawParts{FrictionLaw::cundall_strack, false, false}>("and friction", scenarios, rock());
    built_in("and torsion: the default", scenarios, rock());
    PairMaterial material = rock();
    material.patch_friction = true;
    built_in("  friction on cells", scenarios, material);
    material = rock();
    material.kinetic_friction = 0.3;
    built_in("  kinetic friction", scenarios, material);
    material = rock();
    material.rolling_friction = 0.1;
    built_in<LawParts{.rolling = true}>("  rolling resistance", scenarios, material);
    material = rock();
    material.cohesion = 1;
    built_in("  cohesion", scenarios, material);
    built_in("  stiffness by the patch", scenarios, rock(),
             {.tangential_stiffness = TangentialStiffness::patch});
    built_in("  normal damping by the patch", scenarios, rock(), {.normal_damping = NormalDamping::patch});
    built_in("  exact masses", scenarios, rock(), {.reduced_mass = ReducedMass::exact});
    built_in<LawParts{FrictionLaw::viscous}>("  viscous friction", scenarios, rock());
    row("Hertz and Mindlin", {scenarios.back()}, rock(), HertzMindlin{});
}
