#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double edge = 0.1;
constexpr double depth = 2e-3;
constexpr double rounding = 1e-13;  // of the size: some hundred operations

const Pose askew{{-0.2, 0.6, 1.3}, turned(2.1, {-1, 3, 2})};

// The overlap of two bodies that are turned and shifted together, seen from where they came.
ContactGeometry geometry_of(const Placed& a, const Placed& b) {
    const auto g = overlap_of(moved(a, askew), moved(b, askew));
    REQUIRE(g.has_value());
    ContactGeometry back = *g;
    rotate(back, askew.orientation.toRotationMatrix().transpose());
    back.centroid = askew.inverse() * g->centroid;
    return back;
}

}  // namespace

TEST_CASE("Two boxes face on face with an offset overlap in a box", "[overlap]") {
    const Placed upper = placed(make_box({0.1, 0.2, 0.3}), {0.03, -0.05, 0.15 - depth});
    const Placed lower = placed(make_box({0.1, 0.2, 0.1}), {0, 0, -0.05});
    const ContactGeometry g = geometry_of(upper, lower);
    const Vec3 sides(0.07, 0.15, depth);
    CHECK(g.volume == Approx(sides.prod()).epsilon(1e-12));
    CHECK(deviation(g.centroid, Vec3(0.015, -0.025, -depth / 2), edge) < rounding);
    const double area = 0.07 * 0.15;
    CHECK(deviation(g.area_vector, Vec3(-depth * 0.15, depth * 0.07, -area), area) < 1e-12);
    CHECK(deviation(g.normal, Vec3(depth * 0.15, -depth * 0.07, area).normalized(), 1) < 1e-12);
}

TEST_CASE("A small box deep in a large one's face shows its own face", "[overlap]") {
    // The side faces cancel: S is the lower face alone, whatever the depth.
    const Placed small = placed(make_box({0.02, 0.03, 0.08}), {0.01, 0.02, 0.02});
    const Placed large = placed(make_box({0.4, 0.4, 0.4}), {0, 0, -0.2});
    const ContactGeometry g = geometry_of(small, large);
    const double area = 0.02 * 0.03;
    CHECK(g.volume == Approx(area * 0.02).epsilon(1e-12));
    CHECK(deviation(g.area_vector, Vec3(0, 0, -area), area) < 1e-12);
    CHECK(g.depth == Approx(0.02).epsilon(1e-12));
}

TEST_CASE("Two crossed edges overlap in a tetrahedron", "[overlap]") {
    // Both cubes stand on an edge, A's along x above B's along y. At height z above B's edge, A is 2(z)
    // wide in y and B 2(depth − z) in x: V = ∫ 4 z (depth − z) dz.
    const Quat quarter_x = turned(std::numbers::pi / 4, Vec3::UnitX());
    const Quat quarter_y = turned(std::numbers::pi / 4, Vec3::UnitY());
    const double diagonal = edge / std::numbers::sqrt2;
    const Placed upper = placed(cube(edge), {0, 0, diagonal - depth}, quarter_x);
    const Placed lower = placed(cube(edge), {0, 0, -diagonal}, quarter_y);
    const ContactGeometry g = geometry_of(upper, lower);
    CHECK(g.volume == Approx(2.0 / 3 * depth * depth * depth).epsilon(1e-10));
    CHECK(deviation(g.centroid, Vec3(0, 0, -depth / 2), depth) < 1e-11);
    // dV/d(depth) = 2 depth².
    CHECK(deviation(g.area_vector, Vec3(0, 0, -2 * depth * depth), depth * depth) < 1e-10);
    CHECK(deviation(g.normal, Vec3::UnitZ(), 1) < 1e-10);
    CHECK(g.depth == Approx(depth).epsilon(1e-10));
}

TEST_CASE("A cube's corner in another's face is a tetrahedron, in either order", "[overlap]") {
    const Quat upright = Quat::FromTwoVectors(Vec3(1, 1, 1), Vec3(0, 0, 1));
    const Placed upper = placed(cube(edge), {0.01, 0.02, std::sqrt(3.0) / 2 * edge - depth}, upright);
    const Placed lower = placed(cube(edge), {0, 0, -edge / 2});
    const double reach = std::sqrt(3.0) * depth;
    const double area = std::sqrt(3.0) / 2 * reach * reach;
    for (const bool swapped : {false, true}) {
        const ContactGeometry g = swapped ? geometry_of(lower, upper) : geometry_of(upper, lower);
        const double sign = swapped ? -1 : 1;
        CHECK(g.volume == Approx(reach * reach * reach / 6).epsilon(1e-10));
        CHECK(deviation(g.centroid, Vec3(0.01, 0.02, -depth / 4), depth) < 1e-11);
        CHECK(deviation(g.area_vector, Vec3(0, 0, -sign * area), area) < 1e-10);
        CHECK(deviation(g.normal, Vec3(0, 0, sign), 1) < 1e-10);
        CHECK(g.depth == Approx(depth).epsilon(1e-10));
    }
}

TEST_CASE("Aligned cubes with coplanar sides overlap in one box, stacked and side by side", "[overlap]") {
    // The frame as it is: the side faces are coplanar to the last bit.
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 along = Vec3::Unit(axis);
        const auto g =
            overlap_of(placed(cube(edge), (edge - depth) * along), placed(cube(edge), Vec3::Zero()));
        REQUIRE(g.has_value());
        CHECK(finite(*g));
        CHECK(g->volume == Approx(edge * edge * depth).epsilon(1e-12));
        CHECK(deviation(g->area_vector, -edge * edge * along, edge * edge) < rounding);
        CHECK(deviation(g->normal, along, 1) < rounding);
        CHECK(g->lever == Approx(edge / 6 * (std::sqrt(2.0) + std::asinh(1.0))).epsilon(1e-12));
    }
}

TEST_CASE("Aligned cubes that touch exactly, by face, edge or corner, have no overlap and no NaN",
          "[overlap]") {
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(-1, 1, 0)}) {
        CHECK_FALSE(overlap_of(placed(cube(edge), edge * way), placed(cube(edge), Vec3::Zero())).has_value());
        // A hair of rounding either side must still give something finite.
        for (const double hair : {-4e-17, -1e-17, 1e-17, 4e-17}) {
            const auto g =
                overlap_of(placed(cube(edge), (edge + hair) * way), placed(cube(edge), Vec3::Zero()));
            CHECK((!g || finite(*g)));
        }
    }
}
