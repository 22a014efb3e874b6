#include <catch2/catch.hpp>
#include <scree/overlap/union_volume.hpp>

#include <scree/mesh/mass_properties.hpp>
#include <tests/support/overlaps.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

ConvexPolyhedron box_at(const Vec3& edges, const Vec3& at) {
    return transformed(make_box(edges), {at, Quat::Identity()});
}

}  // namespace

TEST_CASE("The volume of a union counts what is shared once", "[overlap]") {
    const Vec3 unit = Vec3::Ones();
    CHECK(union_volume(std::vector{box_at(unit, {0, 0, 0})}) == Approx(1).epsilon(1e-14));
    CHECK(union_volume(std::vector{box_at(unit, {0, 0, 0}), box_at(unit, {3, 0, 0})}) == Approx(2));
    CHECK(union_volume(std::vector{box_at(unit, {0, 0, 0}), box_at(unit, {0.75, 0, 0})}) == Approx(1.75));
    CHECK(union_volume(std::vector{box_at(unit, {0, 0, 0}), box_at(unit, {0, 0, 0})}) == Approx(1));
    // Three that overlap one another and all together: 3 − (1/2 + 1/2 + 1/4) + 1/4.
    const std::vector<ConvexPolyhedron> three{box_at(unit, {0, 0, 0}), box_at(unit, {0.5, 0, 0}),
                                              box_at(unit, {0, 0.5, 0})};
    CHECK(union_volume(three) == Approx(2));
}

TEST_CASE("The volume of a random union agrees with inclusion and exclusion", "[overlap]") {
    Random random(451);
    OverlapWorkspace workspace;
    for (int i = 0; i < 30; ++i) {
        const ConvexPolyhedron a = random.polyhedron(12);
        const ConvexPolyhedron b =
            transformed(random.polyhedron(12), {0.8 * random.vector(), random.rotation()});
        ContactGeometry shared;
        shared.volume = 0;
        overlap(a, {}, b, {}, Detail::force, false, workspace, shared);
        const double whole = mass_properties(a).volume + mass_properties(b).volume;
        CHECK(union_volume(std::vector{a, b}) == Approx(whole - shared.volume).epsilon(1e-9));
    }
}
