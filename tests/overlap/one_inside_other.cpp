#include <catch2/catch.hpp>

#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// A rod of length 2 along z through a plate, its middle at a height over the plate's.
Placed rod(double height) {
    return placed(make_box({0.1, 0.1, 2}), {0.3, 0.2, height});
}
Placed plate() {
    return placed(make_box({4, 4, 0.2}), {0, 0, 0});
}

}  // namespace

TEST_CASE("A body wholly inside another overlaps by its own volume, along the line of centres", "[overlap]") {
    const Placed inner = placed(icosahedron(0.1), {0.3, 0.1, -0.2}, turned(0.7, {1, 2, 3}));
    const Placed outer = placed(cube(2), {0, 0, 0}, turned(0.2, {1, 0, 1}));
    const double volume =
        10 * (3 + std::sqrt(5.0)) / 24 * std::pow(0.1 / std::sin(0.4 * std::numbers::pi), 3);
    for (const bool swapped : {false, true}) {
        const auto g = swapped ? overlap_of(outer, inner) : overlap_of(inner, outer);
        REQUIRE(g.has_value());
        CHECK(finite(*g));
        CHECK(g->centre_line);
        CHECK_FALSE(g->flat_patch);
        CHECK(g->volume == Approx(volume).epsilon(1e-12));
        CHECK(deviation(g->centroid, inner.pose.position, 0.1) < 1e-12);
        CHECK(g->area < 1e-14);
        const Vec3 apart = (swapped ? -1 : 1) * inner.pose.position;
        CHECK(deviation(g->normal, apart.normalized(), 1) < 1e-12);
        CHECK(g->lever == 0);
    }
}

TEST_CASE("A rod through a plate falls back to the line of centres", "[overlap]") {
    const auto g = overlap_of(rod(0.1), plate());
    REQUIRE(g.has_value());
    CHECK(finite(*g));
    CHECK(g->centre_line);
    CHECK(g->volume == Approx(0.1 * 0.1 * 0.2).epsilon(1e-12));
    CHECK(deviation(g->normal, Vec3(0.3, 0.2, 0.1).normalized(), 1) < 1e-12);
}

TEST_CASE("A rod through a plate has no patch at any tilt", "[overlap]") {
    for (const double tilt : {0.0, 0.1, 0.4, 1.0}) {
        const Placed body = placed(make_box({0.1, 0.1, 2}), {0.3, 0.2, 0.1}, turned(tilt, Vec3::UnitY()));
        CHECK(overlap_of(body, plate()).value().centre_line);
    }
}

TEST_CASE("The line of centres is kept until the patch is twice as large as the one it began with",
          "[overlap]") {
    // The lower end of a tilted rod rises into the plate: its highest corner first, so that the part of the
    // end that is inside, and with it S, grows steadily from nothing.
    const double tilt = 0.1;
    const double highest = -std::cos(tilt) + 0.05 * std::sin(tilt);
    int between = 0;
    for (double rise = -1e-5; rise < 2e-4; rise += 2e-6) {
        const Placed body =
            placed(make_box({0.1, 0.1, 2}), {0, 0, -0.1 - highest + rise}, turned(tilt, Vec3::UnitY()));
        const ContactGeometry fresh = overlap_of(body, plate(), false).value();
        const ContactGeometry kept = overlap_of(body, plate(), true).value();
        // Half the surface of the part inside: sides of length 0.2/cos(tilt), and the two slanted ends.
        const double half = 0.5 * (0.1 + 0.1) * 2 * 0.2 / std::cos(tilt) + 0.01 / std::cos(tilt);
        const double share = fresh.area / half;
        if (std::abs(share - 1e-3) > 2e-5) {  // the end that is inside changes half the surface by a little
            CHECK(fresh.centre_line == (share < 1e-3));
        }
        if (std::abs(share - 2e-3) > 4e-5) {
            CHECK(kept.centre_line == (share < 2e-3));
        }
        between += !fresh.centre_line && kept.centre_line;
    }
    CHECK(between > 5);
}

TEST_CASE("Bodies that coincide exactly overlap wholly and give a finite answer", "[overlap]") {
    for (const Quat& turn : {Quat::Identity(), turned(0.6, {1, 1, -2})}) {
        for (const ConvexPolyhedron& solid : {cube(0.3), icosahedron(0.2), regular_prism(6, 0.1, 0.4)}) {
            const auto g = overlap_of(placed(solid, {1, 2, 3}, turn), placed(solid, {1, 2, 3}, turn));
            REQUIRE(g.has_value());
            const auto whole = overlap_of(placed(solid, {0, 0, -10}), ground());
            CHECK(g->volume == Approx(whole->volume).epsilon(1e-12));
            CHECK(g->centre_line);
            CHECK(g->normal.norm() == Approx(1).epsilon(1e-14));
            CHECK(finite(*g));
        }
    }
}
