#include <catch2/catch.hpp>

#include <tests/overlap/rate_error.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double radius = 0.3;
constexpr double depth = 0.02;
const Pose askew{{0.4, -0.3, 1.2}, turned(0.8, {1, -2, 1})};

// A unit cube about the origin and a sphere whose centre is at a distance along a direction from a point.
Placed block() {
    return moved(placed(cube(1), {0, 0, 0}), askew);
}
Placed ball(const Vec3& from, const Vec3& along) {
    return moved(placed(Sphere{radius}, from + (radius - depth) * along.normalized(), turned(0.5, {1, 1, 0})),
                 askew);
}

}  // namespace

TEST_CASE("A sphere on a polyhedron's face, edge or vertex overlaps in the cap of its depth", "[overlap]") {
    const auto cap = overlap_of(placed(Sphere{radius}, {0, 0, radius - depth}), ground()).value();
    const std::pair<Vec3, Vec3> spots[] = {
        {{0.1, 0.2, 0.5}, {0, 0, 1}}, {{0.1, 0.5, 0.5}, {0, 1, 2}}, {{0.5, -0.5, 0.5}, {1, -2, 1}}};
    for (const auto& [nearest, along] : spots) {
        const auto g = overlap_of(ball(nearest, along), block());
        REQUIRE(g.has_value());
        const Vec3 normal = askew.orientation * along.normalized();
        CHECK(g->volume == Approx(cap.volume).epsilon(1e-12));
        CHECK(g->area == Approx(cap.area).epsilon(1e-12));
        CHECK(g->depth == Approx(depth).epsilon(1e-12));
        CHECK(deviation(g->normal, normal, 1) < 1e-14);
        CHECK(deviation(g->centroid, askew * nearest + cap.centroid.z() * normal, radius) < 1e-14);
        CHECK(deviation(g->area_vector, -cap.area * normal, cap.area) < 1e-12);
        CHECK_FALSE(g->flat_patch);
    }
}

TEST_CASE("Exchanging a sphere and a polyhedron turns the contact round", "[overlap]") {
    const auto forward = overlap_of(ball({0.1, 0.5, 0.5}, {0, 1, 2}), block()).value();
    const auto back = overlap_of(block(), ball({0.1, 0.5, 0.5}, {0, 1, 2})).value();
    CHECK(back.volume == forward.volume);
    CHECK(deviation(back.centroid, forward.centroid, 1) < 1e-15);
    CHECK(back.normal == -forward.normal);
    CHECK(back.area_vector == -forward.area_vector);
}

TEST_CASE("A sphere's rates on a face, an edge and a vertex agree with differences, in either order",
          "[overlap]") {
    for (const Vec3& along : {Vec3(0, 0, 1), Vec3(0, 1, 2), Vec3(1, 2, 2)}) {
        const Placed sphere = ball({along.x() > 0 ? 0.5 : 0.1, along.y() > 0 ? 0.5 : 0.2, 0.5}, along);
        CHECK(derivative_error(sphere, block(), depth, 0.1) < 1e-9);
        CHECK(derivative_error(block(), sphere, depth, 0.1) < 1e-9);
    }
}

TEST_CASE("A sphere rolling over a polyhedron's faces, edges and corners keeps a steady normal and volume",
          "[overlap]") {
    Random random(91);
    const ConvexPolyhedron stone = random.polyhedron(20);
    const double step = 1e-6;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 centre = random.direction() * random.uniform(0.6, 1.2);
        const auto here = overlap_of(placed(Sphere{radius}, centre), placed(stone, {0, 0, 0}));
        const auto there =
            overlap_of(placed(Sphere{radius}, centre + step * random.direction()), placed(stone, {0, 0, 0}));
        if (here && there &&
            here->depth < radius) {  // outside: the nearest point moves no faster than the centre
            CHECK(std::abs(here->depth - there->depth) < 1.001 * step);
            CHECK((here->normal - there->normal).norm() < 1.001 * step / (radius - here->depth));
        }
    }
}

TEST_CASE("A sphere with its centre inside a polyhedron is pushed out of the nearest face", "[overlap]") {
    const auto g = overlap_of(placed(Sphere{radius}, {0.1, 0.2, 0.4}), placed(cube(1), {0, 0, 0})).value();
    CHECK(g.normal == Vec3::UnitZ());
    CHECK(g.depth == Approx(radius + 0.1).epsilon(1e-14));
    const auto sunk = overlap_of(placed(Sphere{0.1}, {0, 0, 0.3}), placed(cube(1), {0, 0, 0})).value();
    CHECK(sunk.centre_line);
    CHECK(finite(sunk));
}
