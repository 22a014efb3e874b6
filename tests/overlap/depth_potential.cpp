#include <cmath>

#include <catch2/catch.hpp>
#include <scree/overlap/depth_potential.hpp>

#include <tests/overlap/random_pairs.hpp>
#include <tests/support/allocations.hpp>
#include <tests/support/finite_difference.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;
using Eigen::VectorXd;

namespace {

struct Met {
    ContactGeometry geometry;  // the centroid in world coordinates
    DepthPotential potential;
};

std::optional<Met> meet(const Placed& a, const Placed& b) {
    Met met;
    OverlapWorkspace workspace;
    if (!overlap(a.shape, a.pose, b.shape, b.pose, Detail::derivative, false, workspace, met.geometry)) {
        return std::nullopt;
    }
    depth_potential(std::get<ConvexPolyhedron>(a.shape), a.pose, met.geometry, Detail::derivative, workspace,
                    met.potential);
    met.geometry.centroid += a.pose.position;
    return met;
}

// Steps of A about the centroid, as shares of a size.
VectorXd scales(double size, double width) {
    VectorXd scale(6);
    scale << Vec3::Constant(size), Vec3::Constant(size / width);
    return scale;
}

// Of force and moment as the gradient of the value, and of their own rates; shares of the largest.
double gradient_error(const Placed& a, const Placed& b, double size, double width) {
    const Met met = meet(a, b).value();
    const Vec3 about = met.geometry.centroid;
    const auto f = [&](const VectorXd& xi) -> VectorXd {
        return VectorXd::Constant(1, -meet(moved(a, about, xi), b).value().potential.value);
    };
    Eigen::MatrixXd gradient(1, 6);
    gradient << met.potential.force.transpose(), met.potential.moment.transpose();
    return jacobian_error(f, VectorXd::Zero(6), gradient, scales(size, width));
}

double rate_error(const Placed& a, const Placed& b, double size, double width) {
    const Met met = meet(a, b).value();
    const Vec3 about = met.geometry.centroid;
    const auto f = [&](const VectorXd& xi) -> VectorXd {
        const Met now = meet(moved(a, about, xi), b).value();
        VectorXd both(6);
        both << now.potential.force,
            now.potential.moment + (now.geometry.centroid - about).cross(now.potential.force);
        return both;
    };
    VectorXd rows(6);
    rows << Vec3::Constant(met.potential.force.norm()), Vec3::Constant(width * met.potential.force.norm());
    return jacobian_error(f, VectorXd::Zero(6), met.potential.rate, scales(size, width), rows);
}

// ∫ 2 × distance from the surface of a box.
double of_box(Vec3 edges) {
    std::sort(edges.begin(), edges.end());
    constexpr int parts = 20000;
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        const double t = edges[0] / 2 * (i + 0.5) / parts;
        sum += (edges - Vec3::Constant(2 * t)).prod() * edges[0] / 2 / parts;
    }
    return 2 * sum;
}

}  // namespace

TEST_CASE("Two cubes that share a cube of edge L hold L⁴/4 and push along its diagonal with L³",
          "[overlap]") {
    const double edge = 0.03;
    const Met met =
        meet(placed(cube(0.1), Vec3::Constant(0.1 - edge)), placed(cube(0.1), Vec3::Zero())).value();
    CHECK(met.potential.value == Approx(std::pow(edge, 4) / 4).epsilon(1e-12));
    CHECK(deviation(met.potential.force, Vec3(Vec3::Constant(std::pow(edge, 3) / 3)), std::pow(edge, 3)) <
          1e-12);
    CHECK(met.potential.moment.norm() < 1e-12 * std::pow(edge, 4));
}

TEST_CASE("The value over a box is twice the mean distance from its surface", "[overlap]") {
    for (const Vec3& edges : {Vec3(0.01, 0.02, 0.05), Vec3(0.03, 0.03, 0.001), Vec3(0.02, 0.02, 0.02)}) {
        const Placed a = placed(make_box(edges + Vec3(1, 0, 0)), {0.5, 0, 0});
        const Placed b = placed(make_box(edges + Vec3(1, 0, 0)), {-0.5, 0, 0});
        const Met met = meet(a, b).value();
        CHECK(met.potential.value == Approx(of_box(edges)).epsilon(1e-7));
    }
}

TEST_CASE("A face on a face has the force, the stiffness and the rocking stiffness of the volume law",
          "[overlap]") {
    for (const double depth : {1e-4, 1e-7, 1e-9}) {
        CAPTURE(depth);
        const Placed a = placed(cube(0.1), {0.01, 0.02, 0.05 - depth});
        const Placed b = placed(make_box({0.3, 0.3, 0.1}), {0, 0, -0.05});
        const Met met = meet(a, b).value();
        const double rim = 4 * depth / 0.1 + 1e-16 / depth;  // the sides' share, and rounding
        const double volume = 0.01 * depth;
        CHECK(met.potential.value == Approx(volume * depth / 2).epsilon(rim));
        CHECK(deviation(met.potential.force, Vec3(0, 0, volume), volume) < rim);
        CHECK(met.potential.rate(2, 2) == Approx(-0.01).epsilon(rim));
        CHECK(met.potential.rate(3, 3) == Approx(-1e-4 / 12).epsilon(rim));
        CHECK(met.potential.rate(4, 4) == Approx(-1e-4 / 12).epsilon(rim));
    }
}

TEST_CASE("Force and moment are the gradient of the value, and their rates agree with differences",
          "[overlap]") {
    Random random(431);
    int overlapping = 0;
    double worst_gradient = 0;
    double worst_rate = 0;
    for (int i = 0; i < 120; ++i) {
        const Placed a = placed(random.polyhedron(12), random.vector(-0.3, 0.3), random.rotation());
        const Placed b =
            placed(random.polyhedron(12), random.direction() * random.uniform(0.6, 1.4), random.rotation());
        const auto met = meet(a, b);
        if (!met || met->geometry.volume < 1e-5 || met->geometry.centre_line) {
            continue;
        }
        const double depth = met->geometry.depth;
        worst_gradient = std::max(worst_gradient, gradient_error(a, b, depth, std::sqrt(met->geometry.area)));
        worst_rate = std::max(worst_rate, rate_error(a, b, depth, std::sqrt(met->geometry.area)));
        ++overlapping;
    }
    CHECK(overlapping > 60);
    CHECK(worst_gradient < 1e-8);
    CHECK(worst_rate < 1e-7);
}

TEST_CASE("Action and reaction of a potential are equal, about one point, and one axis of moments",
          "[overlap]") {
    Random random(432);
    for (int i = 0; i < 100; ++i) {
        const Placed a = placed(random.polyhedron(10), Vec3::Zero(), random.rotation());
        const Placed b =
            placed(random.polyhedron(14), random.direction() * random.uniform(0.8, 1.5), random.rotation());
        const auto one = meet(a, b);
        const auto other = meet(b, a);
        REQUIRE(one.has_value() == other.has_value());
        if (!one || one->geometry.volume < 1e-6) {
            continue;
        }
        const double size = one->geometry.volume;
        CHECK(one->potential.value == Approx(other->potential.value).epsilon(1e-9));
        CHECK(deviation(one->potential.force, -other->potential.force, size) < 1e-9);
        CHECK(deviation(one->potential.moment, -other->potential.moment, size) < 1e-9);
    }
}

TEST_CASE("Potentials of nasty pairs are finite and not negative", "[overlap]") {
    Random random(433);
    const SolidPool pool(random);
    int overlapping = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto met =
            meet({pool.draw(random), nasty_pose(random)}, {pool.draw(random), nasty_pose(random)});
        if (!met) {
            continue;
        }
        ++overlapping;
        const DepthPotential& p = met->potential;
        const double most = met->geometry.volume * 2 * met->geometry.depth + 1e-12;
        CHECK((p.value >= -1e-12 && p.value <= most));
        CHECK((p.force.allFinite() && p.moment.allFinite() && p.rate.allFinite()));
        CHECK(p.force.norm() <= 2 * met->geometry.volume + 1e-12);
    }
    CHECK(overlapping > 500);
}

TEST_CASE("Potentials take no new memory once they have been found", "[overlap]") {
    Random random(434);
    std::vector<std::pair<Placed, Placed>> pairs;
    for (int i = 0; i < 50; ++i) {
        pairs.emplace_back(placed(random.polyhedron(12), Vec3::Zero(), random.rotation()),
                           placed(random.polyhedron(12), random.direction(), random.rotation()));
    }
    OverlapWorkspace workspace;
    ContactGeometry geometry;
    DepthPotential potential;
    const auto sweep = [&] {
        for (const auto& [a, b] : pairs) {
            if (overlap(a.shape, a.pose, b.shape, b.pose, Detail::derivative, false, workspace, geometry)) {
                depth_potential(std::get<ConvexPolyhedron>(a.shape), a.pose, geometry, Detail::derivative,
                                workspace, potential);
            }
        }
    };
    sweep();
    sweep();
    const AllocationCount allocations;
    sweep();
    CHECK(allocations.count() == 0);
}
