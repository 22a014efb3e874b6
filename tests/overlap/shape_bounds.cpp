#include <cmath>

#include <catch2/catch.hpp>

#include <tests/support/random.hpp>
#include <tests/support/solids.hpp>

#include <scree/overlap/shape.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("The bounding radius is the farthest vertex, the sphere's own, or infinite", "[overlap]") {
    CHECK(bounding_radius(make_box({2, 4, 4})) == Approx(3).epsilon(1e-15));
    CHECK(bounding_radius(Sphere{0.7}) == 0.7);
    CHECK(std::isinf(bounding_radius(HalfSpace{})));
}

TEST_CASE("The bounds of a turned box hold all its corners tightly", "[overlap]") {
    Random random(71);
    const ConvexPolyhedron box = make_box({1, 2, 3});
    const Pose pose{random.vector(), random.rotation()};
    const Bounds tight = bounds(box, pose);
    const Vec3 reach = pose.orientation.toRotationMatrix().cwiseAbs() * Vec3(0.5, 1, 1.5);
    CHECK((tight.high - (pose.position + reach)).norm() < 1e-15);
    CHECK((tight.low - (pose.position - reach)).norm() < 1e-15);
}

TEST_CASE("A half-space is bounded only along an axis that is its normal", "[overlap]") {
    const Bounds up = bounds(HalfSpace{Vec3::UnitZ(), 0.5}, {{0, 0, 2}, Quat::Identity()});
    CHECK(up.high.z() == 2.5);
    CHECK((std::isinf(up.low.z()) && std::isinf(up.low.x()) && std::isinf(up.high.x())));
    const Bounds down = bounds(HalfSpace{-Vec3::UnitY(), 0.5}, {{0, 3, 0}, Quat::Identity()});
    CHECK(down.low.y() == 2.5);
    CHECK(std::isinf(down.high.y()));
    const Bounds slanted = bounds(HalfSpace{Vec3(1, 1, 0).normalized(), 0}, {});
    CHECK((std::isinf(slanted.low.x()) && std::isinf(slanted.high.x())));
}

TEST_CASE("The bounds of a sphere are its radius about its centre", "[overlap]") {
    const Bounds box = bounds(Sphere{0.5}, {{1, 2, 3}, turned(1, {1, 1, 1})});
    CHECK(box.low == Vec3(0.5, 1.5, 2.5));
    CHECK(box.high == Vec3(1.5, 2.5, 3.5));
}

TEST_CASE("Round shapes reach as far as their true surfaces", "[overlap]") {
    Random random(72);
    const Frustum cone = make_frustum(0.3, 0.1, 0.4);
    const Capsule capsule = make_capsule(0.2, 0.5);
    CHECK(bounding_radius(capsule) == Approx(0.7));
    CHECK(bounding_radius(cone) == Approx(std::hypot(0.3, 0.4)).epsilon(1e-3));
    for (int i = 0; i < 50; ++i) {
        const Vec3 way = random.direction();
        double farthest = -1;
        for (int j = 0; j < 4000; ++j) {
            const double angle = j * 0.00157079632679;
            for (const auto& [radius, height] : {std::pair(0.3, -0.4), std::pair(0.1, 0.4)}) {
                const Vec3 rim(radius * std::cos(angle), radius * std::sin(angle), height);
                farthest = std::max(farthest, way.dot(rim));
            }
        }
        CHECK(reach_along(cone, way) == Approx(farthest).epsilon(1e-5));
        CHECK(reach_along(capsule, way) == Approx(0.2 + 0.5 * std::abs(way.z())));
        const Pose pose{random.vector(), random.rotation()};
        const Bounds box = bounds(cone, pose);
        const Vec3 along = pose.orientation.conjugate() * Vec3::UnitY();
        CHECK(box.high.y() == Approx(pose.position.y() + reach_along(cone, along)));
        CHECK(box.low.y() == Approx(pose.position.y() - reach_along(cone, -along)));
    }
    const OpenSurface surface{{-1, -2, 0}, {1, 2, 0.5}};
    CHECK(reach_along(surface, Vec3::UnitX()) == 1);
    CHECK(bounds(surface, {{0, 0, 1}, Quat::Identity()}).high.z() == 1.5);
    CHECK(bounding_radius(surface) == Approx(std::sqrt(5.25)));
}
