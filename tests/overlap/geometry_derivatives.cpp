#include <catch2/catch.hpp>

#include <tests/support/finite_difference.hpp>
#include <tests/support/overlaps.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// The error of a closed-form rate of one value by a motion ξ of A about the centroid. Steps are shares of the
// overlap's `depth` and `width` [m]. Errors are shares of the largest entry or, where all vanish (the normal
// of a corner in a face), of `least`: a row with ξ itself stands in for it.
template <class Value>
double rate_error(const Placed& a, const Placed& b, const Value& value, const MatrixXd& rate, double depth,
                  double width, double least) {
    const Vec3 about = overlap_of(a, b).value().centroid;
    const auto f = [&](const VectorXd& xi) -> VectorXd {
        VectorXd row(rate.rows() + 1);
        row << value(overlap_of(moved(a, about, xi), b).value()), least / depth * xi(0);
        return row;
    };
    VectorXd scale(6);
    scale << Vec3::Constant(depth), Vec3::Constant(depth / width);
    MatrixXd with_least = MatrixXd::Zero(rate.rows() + 1, 6);
    with_least.topRows(rate.rows()) = rate;
    with_least(rate.rows(), 0) = least / depth;
    return jacobian_error(f, VectorXd::Zero(6), with_least, scale);
}

// The largest of the errors in V, c, S, ∫ r×n_A dA and n.
double derivative_error(const Placed& a, const Placed& b, double depth, double width) {
    const ContactGeometry g = overlap_of(a, b).value();
    const auto error_of = [&](const auto& value, const MatrixXd& rate, double least) {
        return rate_error(a, b, value, rate, depth, width, least);
    };
    MatrixXd volume_rate(1, 6), centroid_rate(3, 6);
    volume_rate << g.area_vector.transpose(), g.area_moment().transpose();
    centroid_rate << g.first_moment / g.volume, g.second_moment / g.volume;
    const auto moment = [&](const ContactGeometry& now) -> VectorXd {
        return now.area_moment() + (now.centroid - g.centroid).cross(now.area_vector);  // about c as it was
    };
    const auto volume = [](const ContactGeometry& now) { return VectorXd::Constant(1, now.volume); };
    const auto centroid = [](const ContactGeometry& now) { return now.centroid; };
    const auto area_vector = [](const ContactGeometry& now) { return now.area_vector; };
    const auto normal = [](const ContactGeometry& now) { return now.normal; };
    return std::max({error_of(volume, volume_rate, 0), error_of(centroid, centroid_rate, 0),
                     error_of(area_vector, g.boundary.topRows<3>(), g.area * depth / width),
                     error_of(moment, g.boundary.bottomRows<3>(), g.area * depth),
                     error_of(normal, g.normal_rate, depth / width)});
}

}  // namespace

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
