// Nanoseconds of processor time per overlap and per whole contact evaluation, as the median of several
// repetitions.

#include <cstdio>

#include <tests/benchmark/scenarios.hpp>

using namespace scree;
using namespace scree::test;

namespace {

double overlap_time(const Scenario& s, Detail detail) {
    OverlapWorkspace workspace;
    ContactGeometry geometry;
    double sum = 0;
    const double time = nanoseconds([&](std::size_t i) {
        sum += overlap(s.a, s.poses_a[i], s.b, s.pose_b, detail, false, workspace, geometry) ? geometry.volume
                                                                                             : 0;
    });
    return sum > 0 ? time : -1;
}

// Overlap, relative motion, law and settling, as the batch of a step has them.
double contact_time(const Scenario& s, Detail detail) {
    StepCase step;
    for (const Pose& pose : s.poses_a) {
        step.add_body(s.a, pose, Vec3(1e-3, 2e-3, 0), Vec3(0, 0.01, 0));
    }
    const int other = step.add_prescribed(s.b, s.pose_b);
    for (int i = 0; i < other; ++i) {
        step.add_contact(i, other).history.push({Vec3(0.1, 0.2, 0), Vec3::UnitZ()});
    }
    ForcesOf<BuiltInLaw<LawParts{}>> forces({});
    StepProblem problem(step.system, forces);
    step.begin(problem, 1e-9, 1, detail);
    std::vector<ContactResult> results(step.system.contacts.size());
    const std::span<const Contact> contacts(step.system.contacts);
    return nanoseconds([&](std::size_t i) {
        forces.evaluate(contacts.subspan(i, 1), problem.trial(), problem.formulas(), detail,
                        std::span(results).subspan(i, 1));
    });
}

}  // namespace

int main() {
    Random random(1);
    std::printf("%-26s %16s %16s %16s %16s\n", "[ns]", "overlap", "and derivative", "contact",
                "and derivative");
    for (const Scenario& s : {icosahedra(random), cubes_face_on_face(random), cube_on_half_space(random)}) {
        std::printf("%-26s %16.0f %16.0f %16.0f %16.0f\n", s.name.c_str(), overlap_time(s, Detail::force),
                    overlap_time(s, Detail::derivative), contact_time(s, Detail::force),
                    contact_time(s, Detail::derivative));
    }
}
