#pragma once

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include <tests/support/step_case.hpp>

namespace scree::test {

inline constexpr int poses =
    256;  ///< a pair is met at as many poses, so that branches are not learnt by heart
inline constexpr int rounds = 40;  ///< over all poses in one repetition
inline constexpr int repetitions = 15;

/// Two shapes and where they are, one against the other.
struct Scenario {
    std::string name;
    Shape a, b;
    std::vector<Pose> poses_a;
    Pose pose_b;
};

inline Scenario icosahedra(Random& random) {
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

inline Scenario cubes_face_on_face(Random& random) {
    Scenario s{"cubes, face on face", cube(2), cube(2), {}, {Vec3::Zero(), random.rotation()}};
    for (int i = 0; i < poses; ++i) {
        const Pose local{{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 2 - 1e-3},
                         turned(random.uniform(0, 6), Vec3::UnitZ())};
        s.poses_a.push_back(s.pose_b * local);
    }
    return s;
}

inline Scenario cube_on_half_space(Random& random) {
    Scenario s{"cube on half-space", cube(2), HalfSpace{}, {}, {Vec3::Zero(), random.rotation()}};
    for (int i = 0; i < poses; ++i) {
        const Pose local{{random.uniform(-1, 1), random.uniform(-1, 1), 1 - 1e-3},
                         turned(random.uniform(0, 6), Vec3::UnitZ())};
        s.poses_a.push_back(s.pose_b * local);
    }
    return s;
}

/// The median time of one call of work(pose number) [ns].
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

}  // namespace scree::test
