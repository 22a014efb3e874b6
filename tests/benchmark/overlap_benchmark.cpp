// Nanoseconds of processor time per overlap and per whole contact evaluation, as the median of several
// repetitions.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include <tests/support/step_case.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr int poses = 256;  // a pair is met at as many poses, so that branches are not learnt by heart
constexpr int rounds = 40;  // over all poses in one repetition
constexpr int repetitions = 15;

// Two shapes and where they are, one against the other.
struct Scenario {
    std::string name;
    Shape a, b;
    std::vector<Pose> poses_a;
    Pose pose_b;
};

Scenario icosahedra(Random& random) {
    Scenario s{
        "icosahedra, 1e-3 R deep", icosahedron(1), icosahedron(1), {}, {Vec3::Zero(), random.rotation()}};
    OverlapWorkspace workspace;
    ContactGeometry geometry;
    while (s.poses_a.size() < poses) {
        // Along a random line, brought nearer until the depth is right.
        Pose pose{random.direction(), random.rotation()};
        double low = 1;
        double high = 2;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            const Pose at{middle * pose.position, pose.orientation};
            const bool deep = overlap(s.a, at, s.b, s.pose_b, Detail::force, false, workspace, geometry) &&
                              geometry.depth > 1e-3;
            (deep ? low : high) = middle;
        }
        pose.position *= low;
        s.poses_a.push_back(pose);
    }
    return s;
}

Scenario cubes_face_on_face(Random& random) {
    Scenario s{"cubes, face on face", cube(2), cube(2), {}, {Vec3::Zero(), random.rotation()}};
    for (int i = 0; i < poses; ++i) {
        const Pose local{{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 2 - 1e-3},
                         turned(random.uniform(0, 6), Vec3::UnitZ())};
        s.poses_a.push_back(s.pose_b * local);
    }
    return s;
}

Scenario cube_on_half_space(Random& random) {
    Scenario s{"cube on half-space", cube(2), HalfSpace{}, {}, {Vec3::Zero(), random.rotation()}};
    for (int i = 0; i < poses; ++i) {
        const Pose local{{random.uniform(-1, 1), random.uniform(-1, 1), 1 - 1e-3},
                         turned(random.uniform(0, 6), Vec3::UnitZ())};
        s.poses_a.push_back(s.pose_b * local);
    }
    return s;
}

// The median time of one call of work(pose number) [ns].
template <class Work>
double nanoseconds(Work&& work) {
    std::vector<double> times;
    for (int r = 0; r < repetitions; ++r) {
        const std::clock_t start = std::clock();
        for (int i = 0; i < rounds * poses; ++i) {
            work(static_cast<std::size_t>(i % poses));
        }
        times.push_back(1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / (rounds * poses));
    }
    std::nth_element(times.begin(), times.begin() + repetitions / 2, times.end());
    return times[repetitions / 2];
}

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
