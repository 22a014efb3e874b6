#include <cmath>
#include <numbers>
#include <stdexcept>

#include <catch2/catch.hpp>

#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double pi = std::numbers::pi;

double ball(double radius) {
    return 4.0 / 3 * pi * radius * radius * radius;
}

// A solid of revolution about z given by its squared radius at each height: volume and height of the centroid
// by Simpson's rule, exact for the quadratic profiles here.
struct Revolved {
    double volume = 0;
    double moment = 0;

    template <class SquaredRadius>
    void add(double low, double high, SquaredRadius squared) {
        const double middle = 0.5 * (low + high);
        const double weight = pi * (high - low) / 6;
        volume += weight * (squared(low) + 4 * squared(middle) + squared(high));
        moment += weight * (low * squared(low) + 4 * middle * squared(middle) + high * squared(high));
    }
};

}  // namespace

TEST_CASE("A sphere on a half-space overlaps in its cap", "[overlap]") {
    const double radius = 0.3;
    for (const double depth : {1e-6, 0.01, 0.3, 0.5, 0.599}) {
        const double height = radius - depth;
        const auto g =
            overlap_of(placed(Sphere{radius}, {0.1, 0.2, height}, turned(0.3, {1, 2, 3})), ground());
        REQUIRE(g.has_value());
        Revolved cap;
        cap.add(-depth, 0, [&](double z) { return radius * radius - (z - height) * (z - height); });
        // Simpson's own cancellation at the pole: ε R² against 2 R depth.
        const double rounding = 1e-13 + 1e-15 * radius / depth;
        CHECK(g->volume == Approx(cap.volume).epsilon(10 * rounding));
        CHECK(deviation(g->centroid, Vec3(0.1, 0.2, cap.moment / cap.volume), radius) < rounding);
        const double area = pi * (radius * radius - height * height);
        CHECK(deviation(g->area_vector, Vec3(0, 0, -area), area) < rounding);
        CHECK(g->area == Approx(area).epsilon(rounding));
        CHECK(g->depth == Approx(depth).epsilon(rounding));
        CHECK(g->normal == Vec3::UnitZ());
        CHECK_FALSE(g->flat_patch);
        CHECK(g->lever == 0);
        CHECK(finite(*g));
    }
}

TEST_CASE("Two spheres overlap in a lens, of equal and of unequal radii", "[overlap]") {
    for (const double other : {0.3, 0.2, 0.05}) {
        const double radius = 0.3;
        for (const double share : {1e-6, 0.1, 0.5, 0.9}) {
            const double depth = share * 2 * other;
            const double distance = radius + other - depth;
            const Pose askew{{0.5, -0.4, 0.2}, turned(1.2, {2, -1, 1})};
            const auto found = overlap_of(moved(placed(Sphere{radius}, {0, 0, distance}), askew),
                                          moved(placed(Sphere{other}, {0, 0, 0}), askew));
            REQUIRE(found.has_value());
            const Vec3 centroid = askew.inverse() * found->centroid;
            const double rim = (distance * distance - radius * radius + other * other) / (2 * distance);
            Revolved lens;
            lens.add(distance - radius, rim,
                     [&](double z) { return radius * radius - (z - distance) * (z - distance); });
            lens.add(rim, other, [&](double z) { return other * other - z * z; });
            const double rounding = 1e-13 + 2e-15 * radius / depth;  // cancellation at the poles
            CHECK(found->volume == Approx(lens.volume).epsilon(30 * rounding));
            CHECK(deviation(centroid, Vec3(0, 0, lens.moment / lens.volume), radius) < 30 * rounding);
            const double area = pi * (other * other - rim * rim);
            CHECK(found->area == Approx(area).epsilon(30 * rounding));
            CHECK(deviation(found->normal, askew.orientation * Vec3::UnitZ(), 1) < 1e-14);
            CHECK(found->depth == Approx(depth).epsilon(rounding));
            CHECK(finite(*found));
        }
    }
}

TEST_CASE("A sphere wholly inside another or a half-space keeps its volume and has a normal", "[overlap]") {
    const Placed small = placed(Sphere{0.1}, {0, 0.05, 0});
    const Placed large = placed(Sphere{0.4}, {0, 0, 0});
    for (const bool swapped : {false, true}) {
        const auto g = swapped ? overlap_of(large, small) : overlap_of(small, large);
        REQUIRE(g.has_value());
        CHECK(g->centre_line);
        CHECK(g->volume == Approx(ball(0.1)).epsilon(1e-14));
        CHECK(deviation(g->centroid, small.pose.position, 0.1) < 1e-14);
        CHECK(deviation(g->normal, Vec3(0, swapped ? -1 : 1, 0), 1) < 1e-14);
    }
    const auto sunk = overlap_of(placed(Sphere{0.1}, {1, 2, -0.3}), ground());
    REQUIRE(sunk.has_value());
    CHECK(sunk->centre_line);
    CHECK(sunk->volume == Approx(ball(0.1)).epsilon(1e-14));
    CHECK(sunk->normal == Vec3::UnitZ());
    const auto concentric = overlap_of(placed(Sphere{0.1}, {1, 1, 1}), placed(Sphere{0.1}, {1, 1, 1}));
    REQUIRE(concentric.has_value());
    CHECK(finite(*concentric));
    CHECK(concentric->normal.norm() == 1);
}

TEST_CASE("Spheres apart or just touching do not overlap", "[overlap]") {
    CHECK_FALSE(overlap_of(placed(Sphere{0.25}, {0, 0, 0.25}), ground()).has_value());
    CHECK_FALSE(overlap_of(placed(Sphere{0.25}, {0.5, 0, 0}), placed(Sphere{0.25}, {0, 0, 0})).has_value());
    CHECK_FALSE(overlap_of(placed(Sphere{0.25}, {5, 0, 0}), placed(Sphere{0.25}, {0, 0, 0})).has_value());
}

TEST_CASE("Two half-spaces are refused", "[overlap]") {
    CHECK_THROWS_AS(overlap_of(ground(), ground()), std::invalid_argument);
}
