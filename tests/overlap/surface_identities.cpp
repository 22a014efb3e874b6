#include <catch2/catch.hpp>

#include <tests/support/overlaps.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Integrals over the faces of the clipped solid that a predicate picks by their tags.
struct SurfaceIntegrals {
    Vec3 area = Vec3::Zero();
    Mat3 first = Mat3::Zero();   // ∫ r nᵀ dA
    Mat3 second = Mat3::Zero();  // ∫ r (r×n)ᵀ dA

    void add(const Vec3& r, const Vec3& weighted_normal) {
        area += weighted_normal;
        first += r * weighted_normal.transpose();
        second += r * r.cross(weighted_normal).transpose();
    }
};

template <class Wanted>
SurfaceIntegrals integrate(const ClippedSolid& solid, const Vec3& centroid, Wanted&& wanted) {
    SurfaceIntegrals sum;
    for (const ClippedSolid::Face& face : solid.faces()) {
        const auto corner = [&](int e) -> Vec3 {
            return solid.point(solid.half_edges()[static_cast<std::size_t>(e)].vertex) - centroid;
        };
        for (int e = face.begin + 1; wanted(face.tag) && e + 1 < face.end; ++e) {
            const Vec3 p = corner(face.begin);
            const Vec3 q = corner(e);
            const Vec3 r = corner(e + 1);
            const Vec3 third = (q - p).cross(r - p) / 6;
            // Middles of the sides: exact for quadratic integrands.
            sum.add(0.5 * (p + q), third);
            sum.add(0.5 * (q + r), third);
            sum.add(0.5 * (r + p), third);
        }
    }
    return sum;
}

}  // namespace

TEST_CASE(
    "The overlap's whole surface has ∫n = 0, ∫r nᵀ = V 1 and ∫r (r×n)ᵀ = 0; A's part has S and its moments",
    "[overlap]") {
    Random random(51);
    OverlapWorkspace workspace;
    ContactGeometry g;
    int overlapping = 0;
    for (int i = 0; i < 300; ++i) {
        // A's own frame is the world's, so that the clipped solid needs no turning.
        const ConvexPolyhedron a = random.polyhedron(12);
        const ConvexPolyhedron b = random.polyhedron(12);
        const Pose pose{random.direction() * random.uniform(0.2, 1.4), random.rotation()};
        if (!overlap(a, {}, b, pose, Detail::force, false, workspace, g)) {
            continue;
        }
        const ClippedSolid& solid = workspace.clipped;
        const SurfaceIntegrals whole = integrate(solid, g.centroid, [](int) { return true; });
        // Rounding of coordinates of size 1.
        CHECK(deviation(whole.area, Vec3::Zero(), 1) < 1e-14);
        CHECK(deviation(whole.first, g.volume * Mat3::Identity(), 1) < 1e-14);
        CHECK(deviation(whole.second, Mat3::Zero(), 1) < 1e-14);
        const SurfaceIntegrals of_a =
            integrate(solid, g.centroid, [&](int tag) { return tag < a.face_count(); });
        CHECK(deviation(g.area_vector, of_a.area, 1) < 1e-14);
        CHECK(deviation(g.first_moment, of_a.first, 1) < 1e-14);
        CHECK(deviation(g.second_moment, of_a.second, 1) < 1e-14);
        const Vec3 area_moment(of_a.first(1, 2) - of_a.first(2, 1), of_a.first(2, 0) - of_a.first(0, 2),
                               of_a.first(0, 1) - of_a.first(1, 0));
        CHECK(deviation(g.area_moment(), area_moment, 1) < 1e-14);
        ++overlapping;
    }
    CHECK(overlapping > 150);
}

TEST_CASE("A common motion of both bodies does not change V: S and the moment see only relative motion",
          "[overlap]") {
    // dV of B moved is −(S·u + moment·θ): from the exchanged geometry, whose S is −S and moment −moment.
    Random random(52);
    for (int i = 0; i < 50; ++i) {
        const Placed a = placed(random.polyhedron(12), random.vector(-0.3, 0.3), random.rotation());
        const Placed b = placed(random.polyhedron(12), random.vector(-0.3, 0.3), random.rotation());
        const auto ab = overlap_of(a, b);
        const auto ba = overlap_of(b, a);
        REQUIRE((ab && ba));
        CHECK(deviation(ab->area_vector, -ba->area_vector, 1) < 1e-13);
        CHECK(deviation(ab->area_moment(), -ba->area_moment(), 1) < 1e-13);
    }
}

TEST_CASE("The corners of the patch lie on B's surface and inside A", "[overlap]") {
    OverlapWorkspace workspace;
    ContactGeometry g;
    const ConvexPolyhedron a = cube(0.2);
    REQUIRE(
        overlap(a, {{0, 0, 0.09}, Quat::Identity()}, HalfSpace{}, {}, Detail::force, false, workspace, g));
    const std::vector<Vec3> corners = patch_outline(workspace);
    REQUIRE(corners.size() == 4);
    for (const Vec3& corner : corners) {
        CHECK(deviation(corner.cwiseAbs(), Vec3(0.1, 0.1, 0.09), 1) < 1e-15);
        CHECK(corner.z() < 0);
    }
}
