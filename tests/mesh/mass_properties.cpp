#include <scree/mesh/mass_properties.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <catch2/catch.hpp>

#include <scree/mesh/convex_hull.hpp>

#include <tests/support/random.hpp>
#include <tests/support/shapes.hpp>

using namespace scree;

namespace {

constexpr double rounding = 4e-15;

/// The largest deviation of an inertia from another, relative to its size.
double deviation(const Mat3& inertia, const Mat3& expected) {
    return (inertia - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

Vec3 box_inertia(const Vec3& edges) {
    const Vec3 squares = edges.cwiseAbs2();
    return edges.prod() / 12 * (Vec3::Constant(squares.sum()) - squares);
}

Mat3 from_principal(const MassProperties& mass) {
    const Mat3 axes = mass.principal_axes.toRotationMatrix();
    return axes * mass.principal_inertia.asDiagonal() * axes.transpose();
}

}  // namespace

TEST_CASE("Boxes of all sizes have the mass properties of paper", "[mesh]") {
    for (const double scale : {1e-6, 1e-3, 1.0, 1e3}) {
        const Vec3 edges = scale * Vec3(1, 2, 5);
        const MassProperties mass = mass_properties(make_box(edges));
        CHECK(mass.volume == Approx(edges.prod()).epsilon(rounding));
        CHECK(mass.centroid.norm() <= rounding * scale);
        CHECK(deviation(mass.inertia, box_inertia(edges).asDiagonal()) < rounding);
        CHECK(mass.principal_axes.coeffs() == Quat::Identity().coeffs());
        CHECK(mass.principal_inertia == Vec3(mass.inertia.diagonal()));
    }
}

TEST_CASE("The unit cube's volume is exact", "[mesh]") {
    CHECK(std::abs(mass_properties(make_box(Vec3::Ones())).volume - 1) < 1e-15);
}

TEST_CASE("A corner tetrahedron, and the same as a triangle mesh", "[mesh]") {
    const Vec3 legs(1, 2, 4);
    const std::vector<Vec3> corners{Vec3::Zero(), {1, 0, 0}, {0, 2, 0}, {0, 0, 4}};
    const ConvexPolyhedron solid = make_polyhedron(corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    const TriangleMesh surface{corners, {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}};
    // About the corner ∫ x² = V a²/10 and ∫ xy = V ab/20; the centroid is at (a, b, c)/4.
    const double volume = legs.prod() / 6;
    Mat3 spread = volume * (1.0 / 20 - 1.0 / 16) * legs * legs.transpose();
    spread.diagonal() += volume / 20 * legs.cwiseAbs2();
    const Mat3 inertia = spread.trace() * Mat3::Identity() - spread;
    for (const MassProperties& mass : {mass_properties(solid), mass_properties(surface)}) {
        CHECK(mass.volume == Approx(volume).epsilon(rounding));
        CHECK((mass.centroid - legs / 4).norm() < rounding);
        CHECK(deviation(mass.inertia, inertia) < rounding);
        CHECK(deviation(from_principal(mass), inertia) < rounding);
    }
}

TEST_CASE("A hexagonal prism and a rhombic dodecahedron", "[mesh]") {
    const double height = 0.7;
    const MassProperties prism = mass_properties(convex_hull(test::prism_corners(6, height)).solid);
    const double area = 1.5 * std::sqrt(3.0);
    const double across = 5.0 / 24;  // mean of x² over the hexagon of radius 1
    const Vec3 squares(across, across, height * height / 12);
    const Vec3 moments = area * height * (Vec3::Constant(squares.sum()) - squares);
    CHECK(prism.volume == Approx(area * height).epsilon(rounding));
    CHECK(deviation(prism.inertia, moments.asDiagonal()) < rounding);

    const MassProperties rhombic = mass_properties(convex_hull(test::rhombic_dodecahedron_corners()).solid);
    CHECK(rhombic.volume == Approx(16).epsilon(rounding));
    CHECK(deviation(rhombic.inertia, rhombic.inertia(0, 0) * Mat3::Identity()) < rounding);
}

TEST_CASE("Mass properties turn with the body, and are kept far from the origin", "[mesh]") {
    test::Random random(3);
    for (int i = 0; i < 50; ++i) {
        const ConvexPolyhedron solid = random.polyhedron(14, 0.1);
        const MassProperties before = mass_properties(solid);
        const double distance = i % 2 == 0 ? 1 : 1000;
        const Pose motion{distance * random.direction(), random.rotation()};
        const MassProperties after = mass_properties(transformed(solid, motion));
        const Mat3 rotation = motion.orientation.toRotationMatrix();
        const double noise = 1e-14 * distance;
        CHECK(after.volume == Approx(before.volume).epsilon(10 * noise));
        CHECK((after.centroid - motion * before.centroid).norm() < noise);
        CHECK(deviation(after.inertia, rotation * before.inertia * rotation.transpose()) < 20 * noise);
        CHECK(deviation(from_principal(after), after.inertia) < rounding);
        CHECK(after.principal_axes.toRotationMatrix().determinant() == Approx(1));
    }
}

TEST_CASE("Principal axes stay next to the given frame", "[mesh]") {
    test::Random random(4);
    SECTION("a turned cube has no axes of its own") {
        const auto cube = transformed(make_box(Vec3::Ones()), {{}, random.rotation()});
        CHECK(mass_properties(cube).principal_axes.coeffs() == Quat::Identity().coeffs());
    }
    SECTION("a box that is turned a little keeps the order of its axes") {
        const Quat small(Eigen::AngleAxisd(0.2, random.direction()));
        const MassProperties mass = mass_properties(transformed(make_box({3, 1, 2}), {{}, small}));
        CHECK(mass.principal_axes.angularDistance(small) < 1e-13);
        CHECK((mass.principal_inertia - box_inertia({3, 1, 2})).norm() < 1e-13);
    }
    SECTION("equal moments leave no choice to rounding") {
        // Turning a square prism about its own axis changes nothing but rounding.
        const Quat tilt = random.rotation();
        const MassProperties first = mass_properties(transformed(make_box({1, 1, 3}), {{}, tilt}));
        for (int i = 0; i < 20; ++i) {
            const Quat spin(Eigen::AngleAxisd(random.uniform(0, 6), Vec3::UnitZ()));
            const MassProperties mass = mass_properties(transformed(make_box({1, 1, 3}), {{}, tilt * spin}));
            CHECK(mass.principal_axes.angularDistance(first.principal_axes) < 1e-7);
        }
    }
}

TEST_CASE("Inside-out and open surfaces without volume are refused; a sphere's radius", "[mesh]") {
    const TriangleMesh inside_out{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},
                                  {{{0, 1, 2}}, {{0, 3, 1}}, {{1, 3, 2}}, {{2, 3, 0}}}};
    CHECK_THROWS_AS(mass_properties(inside_out), std::invalid_argument);
    CHECK_THROWS_AS(mass_properties(TriangleMesh{}), std::invalid_argument);
    CHECK(sphere_radius(4 * std::numbers::pi / 3) == Approx(1).epsilon(1e-15));
}
