#include <catch2/catch.hpp>

#include <tests/support/overlaps.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// B against A, computed, against A against B, exchanged. `size` [m] is the bodies'.
void check_exchange(const Placed& a, const Placed& b, double size, double tolerance) {
    const auto direct = overlap_of(b, a);
    const auto forward = overlap_of(a, b);
    REQUIRE(direct.has_value() == forward.has_value());
    if (!forward) {
        return;
    }
    // Both in world coordinates, so that nothing has to be shifted.
    const ContactGeometry turned_round = exchanged(*forward, Vec3::Zero());
    const double area = size * size;
    CHECK(std::abs(direct->volume - turned_round.volume) < tolerance * area * size);
    CHECK(deviation(direct->area_vector, turned_round.area_vector, area) < tolerance);
    CHECK(deviation(direct->first_moment, turned_round.first_moment, area * size) < tolerance);
    CHECK(deviation(direct->second_moment, turned_round.second_moment, area * area) < tolerance);
    // What is divided by the volume or the patch loses as many digits.
    const double of_volume = tolerance * area * size / direct->volume;
    CHECK(deviation(direct->centroid, turned_round.centroid, size) < of_volume);
    CHECK(direct->centre_line == turned_round.centre_line);
    CHECK(direct->flat_patch == turned_round.flat_patch);
    CHECK(std::abs(direct->lever - turned_round.lever) < of_volume * size);
    CHECK(std::abs(direct->depth - turned_round.depth) < of_volume * size);
    CHECK(deviation(direct->normal, turned_round.normal, 1) < of_volume);
    const double rates = std::max(direct->normal_rate.cwiseAbs().maxCoeff(), 1 / size);
    CHECK(deviation(direct->normal_rate, turned_round.normal_rate, rates) < of_volume);
    const double lines = std::max(direct->boundary.cwiseAbs().maxCoeff(), size);
    CHECK(deviation(direct->boundary, turned_round.boundary, lines) < of_volume);
}

}  // namespace

TEST_CASE("The overlap of B with A is that of A with B seen from the other side", "[overlap]") {
    Random random(21);
    for (int i = 0; i < 200; ++i) {
        const Placed a = placed(random.polyhedron(12), random.vector(-0.4, 0.4), random.rotation());
        const Placed b =
            placed(random.polyhedron(16), random.direction() * random.uniform(0.2, 1.4), random.rotation());
        check_exchange(a, b, 1, 1e-13);
    }
}

TEST_CASE("A half-space against a polyhedron or a sphere is the same contact turned round", "[overlap]") {
    Random random(22);
    for (int i = 0; i < 50; ++i) {
        const Placed floor{HalfSpace{random.direction(), random.uniform(-1, 1)},
                           {random.vector(), random.rotation()}};
        const Vec3 on_floor =
            floor.pose * (std::get<HalfSpace>(floor.shape).offset * std::get<HalfSpace>(floor.shape).normal);
        const Vec3 height =
            floor.pose.orientation * std::get<HalfSpace>(floor.shape).normal * random.uniform(-0.8, 0.8);
        check_exchange(placed(random.polyhedron(12), on_floor + height, random.rotation()), floor, 1, 1e-13);
        check_exchange(placed(Sphere{1}, on_floor + height, random.rotation()), floor, 1, 1e-13);
    }
}

TEST_CASE("A lens and a sphere inside another are the same contact from either side", "[overlap]") {
    Random random(23);
    for (int i = 0; i < 50; ++i) {
        const Placed a = placed(Sphere{1}, random.vector(), random.rotation());
        const double radius = random.uniform(0.1, 1);
        const Placed b =
            placed(Sphere{radius}, a.pose.position + random.direction() * random.uniform(0.1, 1 + radius),
                   random.rotation());
        check_exchange(a, b, 1, 1e-12);
    }
}

TEST_CASE("One body inside another is the same contact from either side", "[overlap]") {
    Random random(24);
    for (int i = 0; i < 20; ++i) {
        const Placed inner = placed(random.polyhedron(12, 0.2), random.vector(-0.2, 0.2), random.rotation());
        check_exchange(inner, placed(cube(2), Vec3::Zero(), random.rotation()), 1, 1e-13);
    }
}

TEST_CASE("Exchanging shifts the centroid to B's origin", "[overlap]") {
    ContactGeometry g;
    g.centroid = {1, 2, 3};
    CHECK(exchanged(g, {0.5, 0, -1}).centroid == Vec3(0.5, 2, 4));
}
