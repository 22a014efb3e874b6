#include <catch2/catch.hpp>

#include <tests/overlap/closed_surface.hpp>
#include <tests/overlap/random_pairs.hpp>
#include <tests/support/allocations.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

double volume_of(const ConvexPolyhedron& solid) {
    return overlap_of(placed(solid, {0, 0, -10}), ground(), false, Detail::force).value().volume;
}

// Why a geometry cannot be right; empty when it can. `most` [m³] is the smaller body's volume.
std::string fault(const ContactGeometry& g, const ClippedSolid& solid, const ConvexPolyhedron& a,
                  double most) {
    if (!finite(g)) {
        return "not finite";
    }
    if (!(g.volume > 0) || g.volume > most + 1e-14) {
        return "a volume that cannot be";
    }
    if (std::abs(g.normal.norm() - 1) > 1e-14) {
        return "a normal that is not unit";
    }
    if (g.lever < 0 || g.lever > 2 * a.radius || g.depth < 0 || g.depth > 2 * a.radius) {
        return "a lever or a depth that cannot be";
    }
    return surface_fault(solid);
}

// Whether a point is within the box of the vertices, grown by a margin.
bool within(const Vec3& point, const ClippedSolid& solid, double margin) {
    Eigen::AlignedBox3d box;
    for (const int v : solid.vertices()) {
        box.extend(solid.point(v));
    }
    return (point.array() >= box.min().array() - margin).all() &&
           (point.array() <= box.max().array() + margin).all();
}

}  // namespace

TEST_CASE("A hundred thousand random pairs: finite, of possible volume, closed, with the centroid inside",
          "[overlap]") {
    Random random(81);
    const SolidPool pool(random);
    OverlapWorkspace workspace;
    ContactGeometry g;
    int overlapping = 0;
    for (int i = 0; i < 100000; ++i) {
        const ConvexPolyhedron& a = pool.draw(random);
        const ConvexPolyhedron& b = pool.draw(random);
        const Pose pose_a = nasty_pose(random);
        const Pose pose_b = nasty_pose(random);
        if (!overlap(a, pose_a, b, pose_b, Detail::derivative, i % 2 == 0, workspace, g)) {
            continue;
        }
        ++overlapping;
        const std::string found = fault(g, workspace.clipped, a, std::min(volume_of(a), volume_of(b)));
        if (!found.empty()) {
            FAIL_CHECK("pair " << i << ": " << found);
        }
        const Vec3 centroid = pose_a.orientation.conjugate() * g.centroid;
        if (!within(centroid, workspace.clipped, 1e-14)) {
            FAIL_CHECK("pair " << i << ": the centroid is outside, V = " << g.volume);
        }
    }
    CHECK(overlapping > 30000);
}

TEST_CASE("Overlaps do not allocate once the buffers have grown", "[overlap]") {
    Random random(82);
    const SolidPool pool(random);
    std::vector<Placed> bodies;
    for (int i = 0; i < 40; ++i) {
        bodies.push_back({pool.draw(random), nasty_pose(random)});
    }
    bodies.push_back(ground());
    OverlapWorkspace workspace;
    ContactGeometry g;
    int overlapping = 0;
    const auto sweep = [&] {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                overlapping += overlap(bodies[i].shape, bodies[i].pose, bodies[j].shape, bodies[j].pose,
                                       Detail::derivative, false, workspace, g);
            }
        }
    };
    sweep();
    const AllocationCount allocations;
    sweep();
    CHECK(allocations.count() == 0);
    CHECK(overlapping > 300);
}
