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
