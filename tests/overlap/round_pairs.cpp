// Round bodies on edges, on one another and apart; on planes they are in round_solids.cpp.
#include <cmath>
#include <stdexcept>

#include <catch2/catch.hpp>

#include <tests/overlap/round_cases.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::test::round_cases;

TEST_CASE("The rates of round bodies on edges and on one another agree with differences to a few per cent",
          "[overlap]") {
    // The facets follow the direction between the bodies, whose own rate is left out.
    const double depth = 1e-3;
    const Placed ridge =
        moved(placed(make_box({1, 1, 1}), {0, 0, -std::sqrt(0.5)}, turned(pi / 4, {1, 0, 0})), askew);
    const Placed rod = moved(placed(cylinder(), {0.05, 0, -radius}, lying), askew);
    const Placed pill = moved(placed(capsule(), {0.05, 0, -radius}, lying), askew);
    const Quat across = turned(1.1, Vec3::UnitZ()) * lying;
    for (const Shape& shape : {Shape(cylinder()), Shape(capsule())}) {
        for (const Placed& other : {ridge, rod, pill}) {
            const Placed body = sunk(shape, across, depth);
            CHECK(derivative_error(body, other, 0.1 * depth, radius) < 0.04);
            CHECK(derivative_error(other, body, 0.1 * depth, radius) < 0.04);
        }
    }
}

TEST_CASE("Crossed cylinders have the overlap of their curvatures", "[overlap]") {
    // Two quadrics with the gap (x²/R₁ + y²/R₂)/2 sin²γ in oblique axes: V = π δ² √(R₁R₂)/sin γ.
    const double depth = 1e-4;
    for (const double angle : {0.5, 1.0, pi / 2}) {
        for (const Shape& shape : {Shape(cylinder()), Shape(capsule())}) {
            const Placed upper = sunk(shape, turned(angle, Vec3::UnitZ()) * lying, depth);
            const Placed lower = moved(placed(cylinder(), {0.02, 0.01, -radius}, lying), askew);
            const auto g = overlap_of(upper, lower).value();
            CHECK(g.volume == Approx(pi * depth * depth * radius / std::sin(angle)).epsilon(0.01));
            CHECK(deviation(g.normal, askew.orientation * Vec3::UnitZ(), 1) < 1e-3);
        }
    }
}

TEST_CASE("Cylinders side by side and end on end have lenses and whole ends", "[overlap]") {
    const double depth = 1e-3;
    const Placed lower = moved(placed(cylinder(), {0.02, 0.01, -radius}, lying), askew);
    const auto side = overlap_of(sunk(cylinder(), lying, depth), lower).value();
    CHECK(side.volume == Approx(4 * half * segment(radius, radius - depth / 2)).epsilon(3e-3));
    const Placed stump = moved(placed(cylinder(), {0.02, 0.01, -half}, turned(0.7, Vec3::UnitZ())), askew);
    const auto end = overlap_of(sunk(cylinder(), turned(1, Vec3::UnitZ()), depth), stump).value();
    CHECK(end.volume == Approx(pi * radius * radius * depth).epsilon(1e-9));
    CHECK(end.lever == Approx(2 * radius / 3).epsilon(5e-3));
}

TEST_CASE("Capsules side by side rest on a line, end on end on a cap", "[overlap]") {
    const double depth = 1e-3;
    const Placed lower = moved(placed(capsule(), {0.02, 0.01, -radius}, lying), askew);
    const auto side = overlap_of(sunk(capsule(), lying, depth), lower).value();
    CHECK(side.flat_patch);
    // Each end counts as under the other's tangent plane, which is more than the lens that it is.
    const double line = 4 * half * segment(radius, radius - depth / 2);
    const double cap = pi * depth * depth * (radius - depth / 3);
    CHECK(side.volume > line);
    CHECK(side.volume < line + 1.6 * cap);
    CHECK(side.lever == Approx(half / 2).epsilon(0.2));
    const Placed stump = moved(placed(capsule(), {0.02, 0.01, -half - radius}), askew);
    const auto end = overlap_of(sunk(capsule(), Quat::Identity(), depth), stump).value();
    CHECK(end.volume == Approx(pi * depth * depth * (radius - depth / 3)).epsilon(1e-6));
}

TEST_CASE("An end that passes along another capsule changes nothing at once", "[overlap]") {
    const double depth = 1e-3;
    const Placed lower = placed(capsule(), {0, 0, -radius}, lying);
    double before = 0;
    for (int i = 0; i <= 400; ++i) {
        const double way = half - 0.04 + 0.08 * i / 400;
        // The lower one's axis is along −y; past its end the upper one is let down round it.
        const double beyond = std::max(0.0, way - half);
        const double drop = 2 * radius - depth - std::sqrt(std::pow(2 * radius - depth, 2) - beyond * beyond);
        const Placed upper = placed(capsule(), {0, way, half + radius - depth - drop});
        const double volume = overlap_of(upper, lower).value().volume;
        CHECK((i == 0 || std::abs(volume / before - 1) < 0.02));
        before = volume;
    }
}

TEST_CASE("A sphere has the cap of its depth under the nearest point of a round body", "[overlap]") {
    const double ball = 0.05;
    const double depth = 1e-3;
    const double volume = pi * depth * depth * (ball - depth / 3);
    // Where on the body, and the way out there.
    struct Spot {
        Shape shape;
        Vec3 at, out;
    };
    const double slope = radius / (2 * half);
    const Spot spots[] = {
        {cylinder(), {radius, 0, 0.05}, {1, 0, 0}},   {cylinder(), {0.02, 0.03, half}, {0, 0, 1}},
        {cylinder(), {0, radius, -half}, {0, 1, -2}}, {cone(), {0, radius / 2, 0}, {0, 1, slope}},
        {cone(), {0, 0, half}, {0.1, 0.2, 1}},        {cone(), {0, 0, half}, {0, 0, 1}},
        {cone(), {0.01, 0.02, -half}, {0, 0, -1}},    {cone(), {-radius, 0, -half}, {-1, 0, -0.5}},
        {capsule(), {0, -radius, 0.1}, {0, -1, 0}},   {capsule(), {0, 0, half + radius}, {0, 0, 1}}};
    for (const Spot& spot : spots) {
        const Vec3 out = spot.out.normalized();
        const Placed sphere = moved(placed(Sphere{ball}, spot.at + (ball - depth) * out), askew);
        const Placed body = moved(placed(spot.shape, {0, 0, 0}), askew);
        const auto g = overlap_of(sphere, body).value();
        CHECK(g.volume == Approx(volume).epsilon(1e-10));
        CHECK(deviation(g.normal, askew.orientation * out, 1) < 1e-12);
        CHECK(derivative_error(sphere, body, 0.1 * depth, ball) < 1e-8);
        CHECK(derivative_error(body, sphere, 0.1 * depth, ball) < 1e-8);
    }
}

TEST_CASE("Round bodies that are apart do not overlap, and those inside one another stay finite",
          "[overlap]") {
    const Shape shapes[] = {cylinder(), cone(), capsule()};
    for (const Shape& a : shapes) {
        CHECK_FALSE(overlap_of(sunk(a, lying, -1e-6), floor()).has_value());
        CHECK_FALSE(overlap_of(sunk(a, lying, -1e-6), table()).has_value());
        const auto under = overlap_of(placed(a, {0, 0, -1}), ground());
        REQUIRE(under.has_value());
        CHECK(finite(*under));
        for (const Shape& b : {shapes[0], shapes[1], shapes[2], Shape(Sphere{0.05}), Shape(cube(0.1))}) {
            CHECK_FALSE(overlap_of(placed(a, {0, 0, 1}), placed(b, {0, 0, 0})).has_value());
            const auto inside = overlap_of(placed(a, {0, 0, 0}), placed(b, {0, 0, 0}));
            REQUIRE(inside.has_value());
            CHECK(finite(*inside));
            CHECK(inside->normal.norm() == Approx(1).epsilon(1e-12));
        }
    }
}

TEST_CASE("Round shapes without a size are refused, and open surfaces share nothing", "[overlap]") {
    CHECK_THROWS_AS(make_frustum(0, 0, 1), std::invalid_argument);
    CHECK_THROWS_AS(make_frustum(1, -1, 1), std::invalid_argument);
    CHECK_THROWS_AS(make_frustum(1, 1, 0), std::invalid_argument);
    CHECK_THROWS_AS(make_frustum(1, std::nan(""), 1), std::invalid_argument);
    CHECK_THROWS_AS(make_capsule(1, 0), std::invalid_argument);
    CHECK_THROWS_AS(overlap_of(placed(OpenSurface{}, {0, 0, 0}), ground()), std::invalid_argument);
    CHECK_THROWS_AS(overlap_of(placed(capsule(), {0, 0, 0}), placed(OpenSurface{}, {0, 0, 0})),
                    std::invalid_argument);
}
