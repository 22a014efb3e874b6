#include <cmath>
#include <numbers>
#include <stdexcept>

#include <catch2/catch.hpp>

#include <tests/overlap/rate_error.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 0.1;
constexpr double half = 0.15;  // height or length
// What the facets are promised to keep.
constexpr double faceted_volume = 1.4e-3;
constexpr double faceted_width = 1e-2;

const Pose askew{{0.4, -0.3, 1.2}, turned(0.8, {1, -2, 1})};
const Quat lying = turned(pi / 2, {1, 0, 0});

Frustum cylinder() {
    return make_frustum(radius, radius, half);
}
Frustum cone() {
    return make_frustum(radius, 0, half);
}
Capsule capsule() {
    return make_capsule(radius, half);
}
const Quat cone_lying = turned(pi / 2 + std::atan(radius / (2 * half)), {1, 0, 0});

// A shape turned and then sunk into the ground by a depth, all of it moved to an odd place.
Placed sunk(const Shape& shape, const Quat& turn, double depth) {
    const double lowest = reach_along(shape, turn.conjugate() * -Vec3::UnitZ());
    return moved(placed(shape, {0.02, 0.01, lowest - depth}, turn), askew);
}
Placed floor() {
    return moved(ground(), askew);
}
Placed table() {
    return moved(placed(make_box({1, 1, 0.5}), {0, 0, -0.25}), askew);
}

// Area of the part of a disc that a line at a distance from its centre cuts off.
double segment(double disc, double distance) {
    return disc * disc * std::acos(distance / disc) -
           distance * std::sqrt((disc - distance) * (disc + distance));
}

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
