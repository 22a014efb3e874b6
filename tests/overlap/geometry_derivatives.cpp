#include <catch2/catch.hpp>

#include <tests/overlap/rate_error.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("dV, dc, dS, d∫r×n dA and dn agree with differences for random polyhedra", "[overlap]") {
    Random random(31);
    int overlapping = 0;
    double worst = 0;
    for (int i = 0; i < 120; ++i) {
        const Placed a = placed(random.polyhedron(12), random.vector(-0.3, 0.3), random.rotation());
        const Placed b =
            placed(random.polyhedron(12), random.direction() * random.uniform(0.6, 1.4), random.rotation());
        const auto g = overlap_of(a, b);
        if (!g || g->volume < 1e-5) {
            continue;
        }
        worst = std::max(worst, derivative_error(a, b, g->depth, std::sqrt(g->area)));
        ++overlapping;
    }
    INFO("worst error " << worst);
    CHECK(overlapping > 60);
    // Central differences: a third power of the step against rounding, at sides of a hundredth of the size.
    CHECK(worst < 1e-8);
}

TEST_CASE("dV, dc, dS, d∫r×n dA and dn agree with differences for a face, an edge and a corner",
          "[overlap]") {
    const double depth = 1e-4;
    const Placed floor = moved(ground(), {{0.1, 0.2, 0.3}, turned(0.4, {1, -1, 2})});
    const auto above = [&](double height, const Quat& turn) {
        return moved(placed(cube(0.1), {0.2, 0.1, height}, turn), floor.pose);
    };
    const double tilt = 1e-5;
    CHECK(derivative_error(above(0.05 - depth, turned(tilt, {1, 2, 0})), floor, depth, 0.1) < 1e-8);
    const Quat on_edge = turned(std::atan(1.0) + 0.1, Vec3::UnitX());
    const double half_edge = 0.05 * (std::cos(std::atan(1.0) + 0.1) + std::sin(std::atan(1.0) + 0.1));
    CHECK(derivative_error(above(half_edge - depth, on_edge), floor, depth, 0.1) < 1e-8);
    const Quat on_corner = Quat::FromTwoVectors(Vec3(1, 1.2, 0.9), Vec3::UnitZ());
    const double lowest = (on_corner.toRotationMatrix().row(2).cwiseAbs() * Vec3::Constant(0.05))(0);
    CHECK(derivative_error(above(lowest - depth, on_corner), floor, depth, depth) < 1e-7);
}

TEST_CASE("dV, dc, dS, d∫r×n dA and dn agree with differences for spheres", "[overlap]") {
    const Placed floor = moved(ground(), {{0.1, 0.2, 0.3}, turned(0.4, {1, -1, 2})});
    const Placed ball = moved(placed(Sphere{0.1}, {0.3, 0.2, 0.08}), floor.pose);
    CHECK(derivative_error(ball, floor, 0.02, 0.1) < 1e-9);
    CHECK(derivative_error(floor, ball, 0.02, 0.1) < 1e-9);
    const Placed other = placed(Sphere{0.07}, ball.pose.position + 0.14 * Vec3(1, 2, 2) / 3);
    CHECK(derivative_error(ball, other, 0.02, 0.1) < 1e-9);
    CHECK(derivative_error(other, ball, 0.02, 0.1) < 1e-9);
}

TEST_CASE("The line of centres has the right derivative: one inside the other, a rod through a plate",
          "[overlap]") {
    const Placed outer = placed(cube(2), {0.1, 0, 0}, turned(0.3, {1, 1, 1}));
    const Placed inner = placed(icosahedron(0.2), {0.4, 0.3, -0.2}, turned(1, {0, 1, 1}));
    const auto line_error = [](const Placed& a, const Placed& b) {
        const ContactGeometry g = overlap_of(a, b).value();
        REQUIRE(g.centre_line);
        return rate_error(
            a, b, [](const ContactGeometry& now) { return now.normal; }, g.normal_rate, 0.1, 0.1, 0);
    };
    CHECK(line_error(inner, outer) < 1e-9);
    CHECK(line_error(outer, inner) < 1e-9);
    CHECK(line_error(placed(Sphere{0.1}, {0.1, 0.1, 0}), placed(Sphere{0.5}, {0, 0, 0})) < 1e-9);
    CHECK(line_error(placed(Sphere{0.5}, {0.1, 0.1, 0}), placed(Sphere{0.1}, {0, 0, 0})) < 1e-9);
    const Placed rod = placed(make_box({0.1, 0.1, 2}), {0.3, 0.2, 0.3}, turned(0.2, {1, 1, 0}));
    const Placed plate = placed(make_box({4, 4, 0.2}), {0, 0, 0});
    CHECK(line_error(rod, plate) < 1e-9);
    CHECK(line_error(plate, rod) < 1e-9);
}

TEST_CASE(
    "The depth moment over a half-space is a potential: its gradient is V, and a turn about c leaves it",
    "[overlap]") {
    const Placed floor = moved(ground(), {{0.1, 0.2, 0.3}, turned(0.4, {1, -1, 2})});
    Random random(32);
    for (int i = 0; i < 20; ++i) {
        const Vec3 height(0, 0, random.uniform(-1.5, 0.5));
        for (const Shape& shape : {Shape(random.polyhedron(12)), Shape(Sphere{1})}) {
            const Placed body = moved(placed(shape, height, random.rotation()), floor.pose);
            const ContactGeometry g = overlap_of(body, floor).value();
            Eigen::MatrixXd rate = Eigen::MatrixXd::Zero(1, 6);
            rate.leftCols<3>() = -g.volume * g.normal.transpose();
            const auto moment = [](const ContactGeometry& now) {
                return Eigen::VectorXd::Constant(1, now.depth_moment);
            };
            CHECK(rate_error(body, floor, moment, rate, 0.1, 1, 0) < 1e-9);
        }
    }
}
