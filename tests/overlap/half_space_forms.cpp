#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <tests/support/overlaps.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double edge = 0.2;
constexpr double depth = 0.01;
constexpr double rounding =
    1e-13;  // of the size: some hundred operations, a depth of a twentieth of the size

// The same solid and ground, turned and shifted together: closed forms in the ground's own frame.
const Pose askew{{0.3, -1.1, 0.7}, turned(0.9, {1, 2, -1})};

ContactGeometry on_ground(const ConvexPolyhedron& solid, const Pose& pose) {
    const auto g = overlap_of(moved({solid, pose}, askew), moved(ground(), askew));
    REQUIRE(g.has_value());
    ContactGeometry back = *g;
    rotate(back, askew.orientation.toRotationMatrix().transpose());
    back.centroid = askew.inverse() * g->centroid;
    return back;
}

}  // namespace

TEST_CASE("A cube's face on a half-space has V, c, S, n, depth and lever in closed form", "[overlap]") {
    const ContactGeometry g =
        on_ground(cube(edge), {{0.4, 0.5, edge / 2 - depth}, turned(0.3, Vec3::UnitZ())});
    CHECK(g.volume == Approx(edge * edge * depth).epsilon(rounding * edge / depth));
    CHECK(deviation(g.centroid, Vec3(0.4, 0.5, -depth / 2), edge) < rounding);
    CHECK(deviation(g.area_vector, Vec3(0, 0, -edge * edge), edge * edge) < rounding);
    CHECK(deviation(g.normal, Vec3::UnitZ(), 1) < rounding);
    CHECK(g.area == Approx(edge * edge).epsilon(rounding));
    CHECK(g.depth == Approx(depth).epsilon(1e-12));
    const double lever = edge / 6 * (std::sqrt(2.0) + std::asinh(1.0));
    CHECK(g.lever == Approx(lever).epsilon(1e-12));
    CHECK(g.flat_patch);
    CHECK_FALSE(g.centre_line);
}

TEST_CASE("A tilted cube's face under water is a box with a slanted top", "[overlap]") {
    // Heights of the face's corners stay below the ground: the mean depth makes V, the wedge shifts c.
    const double tilt = 0.05;
    const double middle = 0.02;  // depth of the face's middle along the cube's own axis
    const Quat turn = turned(tilt, Vec3::UnitY());
    const Vec3 down = turn * Vec3(0, 0, -1);
    const Vec3 position = -(edge / 2 - middle) * down;
    const ContactGeometry g = on_ground(cube(edge), {position, turn});
    CHECK(g.volume == Approx(edge * edge * middle).epsilon(1e-12));
    // The wedge's height over the face: middle + x tan(tilt), with x along the cube's own axis.
    const double slope = std::tan(tilt);
    const double second = edge * edge / 12;
    const double x = slope * second / middle;
    const double z = (middle * middle + slope * slope * second) / (2 * middle);
    const Vec3 face_middle = position + edge / 2 * down;
    const Vec3 centroid = face_middle - z * down + turn * Vec3(x, 0, 0);
    CHECK(deviation(g.centroid, centroid, edge) < rounding);
    CHECK(deviation(g.area_vector, Vec3(0, 0, -edge * edge / std::cos(tilt)), edge * edge) < rounding);
    CHECK(g.depth == Approx(middle * std::cos(tilt) + edge / 2 * std::sin(tilt)).epsilon(1e-12));
}

TEST_CASE("A cube's edge on a half-space is a triangular prism", "[overlap]") {
    const ContactGeometry g = on_ground(cube(edge), {{0, 0, edge / std::numbers::sqrt2 - depth},
                                                     turned(std::numbers::pi / 4, Vec3::UnitX())});
    CHECK(g.volume == Approx(depth * depth * edge).epsilon(1e-12));
    CHECK(deviation(g.centroid, Vec3(0, 0, -depth / 3), edge) < rounding);
    CHECK(deviation(g.area_vector, Vec3(0, 0, -2 * depth * edge), edge * edge) < rounding);
    CHECK(g.depth == Approx(depth).epsilon(1e-12));
}

TEST_CASE("A cube's corner on a half-space is a tetrahedron", "[overlap]") {
    // The space diagonal upright: the three edges from the lowest corner reach depth √3 along themselves.
    const Quat turn = Quat::FromTwoVectors(Vec3(1, 1, 1), Vec3(0, 0, 1));
    const ContactGeometry g = on_ground(cube(edge), {{0, 0, std::sqrt(3.0) / 2 * edge - depth}, turn});
    const double reach = std::sqrt(3.0) * depth;
    CHECK(g.volume == Approx(reach * reach * reach / 6).epsilon(1e-11));
    CHECK(deviation(g.centroid, Vec3(0, 0, -depth / 4), depth) < 1e-12);
    const double area = std::sqrt(3.0) / 2 * reach * reach;
    CHECK(deviation(g.area_vector, Vec3(0, 0, -area), area) < 1e-12);
    CHECK(g.depth == Approx(depth).epsilon(1e-12));
    // An equilateral triangle of side s: six right triangles with the angle 60° at the middle.
    const double h = std::numbers::sqrt2 * reach / (2 * std::sqrt(3.0));
    const double lever = 6 * h * h * h / 6 * (std::sqrt(3.0) * 2 + std::asinh(std::sqrt(3.0))) / area;
    CHECK(g.lever == Approx(lever).epsilon(1e-11));
}

TEST_CASE("A polyhedron wholly in a half-space keeps its volume and takes the ground's normal", "[overlap]") {
    const ContactGeometry g = on_ground(cube(edge), {{0.1, 0.2, -edge}, turned(0.4, {1, 1, 0})});
    CHECK(g.volume == Approx(edge * edge * edge).epsilon(1e-13));
    CHECK(g.centre_line);
    CHECK_FALSE(g.flat_patch);
    CHECK(deviation(g.normal, Vec3::UnitZ(), 1) < rounding);
    CHECK(deviation(g.centroid, Vec3(0.1, 0.2, -edge), edge) < rounding);
    CHECK(g.lever == 0);
    CHECK(finite(g));
}

TEST_CASE("The lever of a many-sided patch is two thirds of the disc's radius", "[overlap]") {
    const double radius = 0.1;
    for (const int corners : {3, 4, 6, 12, 60, 240}) {
        const auto g = overlap_of(placed(regular_prism(corners, radius, 0.1), {0.2, 0, 0.049}), ground());
        REQUIRE(g.has_value());
        // Each half side: a right triangle with height h and angle α at the middle.
        const double angle = std::numbers::pi / corners;
        const double h = radius * std::cos(angle);
        const double t = std::tan(angle);
        const double integral = 2 * corners * h * h * h / 6 * (t * std::hypot(1, t) + std::asinh(t));
        CHECK(g->lever == Approx(integral / (corners * h * h * t)).epsilon(1e-11));
        if (corners == 240) {
            CHECK(g->lever == Approx(2 * radius / 3).epsilon(2 * angle * angle));
        }
    }
}

TEST_CASE("A polyhedron above a half-space does not overlap it, one that just touches has no volume",
          "[overlap]") {
    CHECK_FALSE(overlap_of(placed(cube(edge), {0, 0, edge / 2 + 1e-9}), ground()).has_value());
    CHECK_FALSE(overlap_of(placed(cube(edge), {0, 0, edge / 2}), ground()).has_value());
    CHECK_FALSE(overlap_of(placed(cube(edge), {0, 0, 10}), ground()).has_value());
}
