#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <tests/overlap/round_cases.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::test::round_cases;

namespace {

// What the facets are promised to keep.
constexpr double faceted_volume = 1.4e-3;
constexpr double faceted_width = 1e-2;

// The volume under the ground of a solid of revolution with the given radius along its axis, whose centre is
// at a height and whose axis rises by the sine of an angle: slices across the axis, Simpson's rule.
template <class Radius>
double sliced_volume(double length, double height, double sine, Radius&& radius_at) {
    constexpr int slices = 20000;
    const double cosine = std::sqrt(1 - sine * sine);
    double sum = 0;
    for (int i = 0; i <= slices; ++i) {
        const double z = -length + 2 * length * i / slices;
        const double disc = radius_at(z);
        const double distance = (height + z * sine) / cosine;
        const double area = distance >= disc    ? 0
                            : distance <= -disc ? pi * disc * disc
                                                : segment(disc, distance);
        sum += (i == 0 || i == slices ? 1 : i % 2 == 1 ? 4 : 2) * area;
    }
    return sum * 2 * length / slices / 3;
}

double capsule_radius(double z) {
    const double beyond = std::max(0.0, std::abs(z) - half);
    return std::sqrt(std::max(0.0, (radius - beyond) * (radius + beyond)));
}

}  // namespace

TEST_CASE("A cylinder and a capsule on their sides have the volume and the patch of circular segments",
          "[overlap]") {
    for (const double depth : {1e-8, 1e-6, 1e-4, 1e-2}) {
        const double length = 2 * half;
        const double area = segment(radius, radius - depth);
        const double width = 2 * std::sqrt(depth * (2 * radius - depth));
        for (const Placed& ground_or_table : {floor(), table()}) {
            const auto rod = overlap_of(sunk(cylinder(), lying, depth), ground_or_table).value();
            CHECK(rod.volume == Approx(length * area).epsilon(faceted_volume));
            CHECK(rod.area == Approx(length * width).epsilon(faceted_width));
            CHECK(rod.depth == Approx(depth).epsilon(1e-3));
            CHECK(deviation(rod.normal, askew.orientation * Vec3::UnitZ(), 1) < 1e-9);

            const double cap = pi * depth * depth * (radius - depth / 3);
            const auto pill = overlap_of(sunk(capsule(), lying, depth), ground_or_table).value();
            CHECK(pill.volume == Approx(length * area + cap).epsilon(faceted_volume));
            CHECK(pill.area == Approx(length * width + pi * width * width / 4).epsilon(faceted_width));
        }
    }
}

TEST_CASE("A whole end on a plane has the exact volume, centroid and moments, however it is turned",
          "[overlap]") {
    const double depth = 1e-3;
    for (const double tilt : {0.0, 1e-9, 1e-7, 1e-3}) {
        const Vec3 axis(std::cos(tilt * 1e3), std::sin(tilt * 1e3), 0);
        const Quat turn = turned(tilt, axis) * turned(1, Vec3::UnitZ());
        const Placed rod = moved(placed(cylinder(), {0, 0, half - depth}, turn), askew);
        const auto g = overlap_of(rod, floor()).value();
        // The end's depth is linear over a disc, and under a tilt its second moment moves the centroid.
        const double volume =
            pi * radius * radius * (depth + half * (std::cos(tilt) - 1) / std::cos(tilt)) * std::cos(tilt);
        CHECK(g.volume == Approx(volume).epsilon(3e-6));
        const double aside = tilt * radius * radius / 4 / depth;
        const Vec3 down = turned(tilt, axis) * Vec3(0, 0, -half) + Vec3(0, 0, half - depth);
        const Vec3 expected = down + aside * Vec3(axis.y(), -axis.x(), 0) * (tilt > 0 ? 1 : 0);
        const Vec3 found = askew.inverse() * g.centroid;
        CHECK(deviation(found.head<2>().eval(), expected.head<2>().eval(), radius) < 2e-5);
        CHECK(g.area == Approx(pi * radius * radius).epsilon(1e-6));
        CHECK(g.lever == Approx(2 * radius / 3).epsilon(5e-3));
        // The end's second moment about the centroid, across the normal.
        const Mat3 across = Mat3::Identity() - g.normal * g.normal.transpose();
        const Vec3 off = across * (askew.orientation * (found - down));
        const Mat3 spread = across * g.second_moment * cross_matrix(g.normal) * across;
        const Mat3 disc = pi * radius * radius * (radius * radius / 4 * across + off * off.transpose());
        CHECK(deviation(spread, disc, disc(0, 0)) < 1e-5);
    }
}

TEST_CASE("A cone on its base, its side and its tip", "[overlap]") {
    const double depth = 1e-3;
    const auto base = overlap_of(sunk(cone(), Quat::Identity(), depth), floor()).value();
    const double upper = radius * (1 - depth / (2 * half));
    const double slice = pi / 3 * depth * (radius * radius + radius * upper + upper * upper);
    CHECK(base.volume == Approx(slice).epsilon(1e-12));

    const auto tip = overlap_of(sunk(cone(), turned(pi, {1, 0, 0}), depth), floor()).value();
    const double small = radius * depth / (2 * half);
    CHECK(tip.volume == Approx(pi / 3 * small * small * depth).epsilon(1e-12));

    for (const double deep : {1e-6, 1e-4}) {
        const double length = std::hypot(radius, 2 * half);
        const double height = reach_along(cone(), cone_lying.conjugate() * -Vec3::UnitZ()) - deep;
        const double sine = (cone_lying * Vec3::UnitZ()).z();
        const double volume = sliced_volume(half, height, sine, [](double z) { return cone().radius_at(z); });
        const auto side = overlap_of(sunk(cone(), cone_lying, deep), floor()).value();
        CHECK(side.volume == Approx(volume).epsilon(2 * faceted_volume));
        CHECK(side.lever < length);
    }
}

TEST_CASE("A tilted cylinder or capsule has the volume of its slices", "[overlap]") {
    for (const double depth : {1e-5, 1e-3, 2e-2}) {
        for (const double angle : {0.01 * std::sqrt(depth), 0.3 * std::sqrt(depth), std::sqrt(20 * depth)}) {
            const Quat turn = turned(angle, {0, 1, 0}) * turned(pi / 2, {0, 1, 0});
            const double sine = std::abs((turn * Vec3::UnitZ()).z());
            for (const Shape& shape : {Shape(cylinder()), Shape(capsule())}) {
                const bool round = std::holds_alternative<Capsule>(shape);
                const double height = reach_along(shape, turn.conjugate() * -Vec3::UnitZ()) - depth;
                const double reach = round ? half + radius : half;
                const double volume = sliced_volume(
                    reach, height, sine, [&](double z) { return round ? capsule_radius(z) : radius; });
                const auto g = overlap_of(sunk(shape, turn, depth), floor()).value();
                CHECK(g.volume == Approx(volume).epsilon(3 * faceted_volume));
            }
        }
    }
}

TEST_CASE("A capsule that stands or leans on an end has the cap of its sphere", "[overlap]") {
    const double depth = 1e-3;
    for (const double tilt : {0.0, 0.5, 1.2}) {
        const Placed pill = sunk(capsule(), turned(tilt, {1, 0.5, 0}), depth);
        const Vec3 end = pill.pose * Vec3(0, 0, -half);
        for (const Placed& ground_or_table : {floor(), table()}) {
            const auto g = overlap_of(pill, ground_or_table).value();
            const auto ball = overlap_of(placed(Sphere{radius}, end), ground_or_table).value();
            CHECK(g.volume == Approx(ball.volume).epsilon(1e-9));
            CHECK(deviation(g.centroid, ball.centroid, radius) < 1e-9);
            CHECK(deviation(g.area_vector, ball.area_vector, ball.area) < 1e-9);
            CHECK(deviation(g.first_moment, ball.first_moment, ball.volume) < 1e-8);
            CHECK(deviation(g.boundary, ball.boundary, ball.boundary.cwiseAbs().maxCoeff()) < 1e-8);
            CHECK_FALSE(g.flat_patch);
            CHECK(g.lever == Approx(0).margin(1e-12));
        }
    }
}

TEST_CASE("A spin about its own axis changes nothing in what a solid of revolution shares", "[overlap]") {
    Random random(81);
    const Placed stone = placed(random.polyhedron(20, 0.3), {0, 0, -0.3}, random.rotation());
    const Placed rod = placed(cylinder(), {0.05, 0, -radius}, turned(1, Vec3::UnitZ()) * lying);
    for (const Shape& shape : {Shape(cylinder()), Shape(cone()), Shape(capsule())}) {
        for (int i = 0; i < 20; ++i) {
            const Quat turn = random.rotation();
            const double lowest = reach_along(shape, turn.conjugate() * -Vec3::UnitZ());
            const Placed body = placed(shape, {0, 0, lowest - 0.02}, turn);
            const Placed spun{shape, body.pose * Pose{Vec3::Zero(), turned(random.uniform(0, 6), {0, 0, 1})}};
            for (const Placed& other : {ground(), stone, rod}) {
                const auto before = overlap_of(body, other);
                const auto after = overlap_of(spun, other);
                REQUIRE(before.has_value() == after.has_value());
                if (before) {
                    CHECK(after->volume == Approx(before->volume).epsilon(1e-8));
                    CHECK(deviation(after->centroid, before->centroid, radius) < 1e-8);
                    CHECK(deviation(after->normal, before->normal, 1) < 1e-8);
                }
            }
        }
    }
}

TEST_CASE("On flat ground a solid of revolution feels no moment about its axis", "[overlap]") {
    Random random(82);
    for (const Shape& shape : {Shape(cylinder()), Shape(cone()), Shape(capsule())}) {
        for (int i = 0; i < 50; ++i) {
            const Placed body = sunk(shape, random.rotation(), 0.3 * radius * random.uniform());
            const auto g = overlap_of(body, floor()).value();
            const Vec3 axis = body.pose.orientation * Vec3::UnitZ();
            const Vec3 moment = (g.centroid - body.pose.position).cross(g.normal);
            CHECK(std::abs(moment.dot(axis)) / radius < 1e-12);
            CHECK((g.tilting.transpose() * axis).norm() < 1e-14);
        }
    }
}

TEST_CASE("The rates of solids of revolution on a plane agree with differences", "[overlap]") {
    for (const double depth : {1e-4, 1e-3}) {
        const double tilt = depth / radius;
        const Quat turns[] = {lying, turned(0.5, {1, 0.3, 0}), turned(0.2 * tilt, {1, 0.3, 0}),
                              turned(0.3 * tilt, {0, 1, 0}) * lying, turned(2.5, {1, 0.2, 0})};
        for (const Quat& turn : turns) {
            for (const Shape& shape : {Shape(cylinder()), Shape(cone()), Shape(capsule())}) {
                const Placed body = sunk(shape, turn, depth);
                CAPTURE(depth, turn.coeffs().transpose(), shape.index());
                CHECK(derivative_error(body, floor(), 0.1 * depth, radius) < 1e-7);
                CHECK(derivative_error(body, table(), 0.1 * depth, radius) < 1e-7);
                CHECK(derivative_error(table(), body, 0.1 * depth, radius) < 1e-7);
            }
        }
    }
}
