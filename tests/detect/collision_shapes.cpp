#include <catch2/catch.hpp>

#include <scree/detect/collision_shapes.hpp>
#include <scree/detect/convert.hpp>
#include <tests/support/random.hpp>

using namespace scree;

TEST_CASE("poses survive the way to Bullet and back") {
    test::Random random(1);
    for (int i = 0; i < 100; ++i) {
        const Pose pose{random.vector(), random.rotation()};
        const Pose back = to_eigen(to_bullet(pose));
        CHECK(back.position == pose.position);
        CHECK(back.orientation.angularDistance(pose.orientation) < 1e-15);
    }
    const Pose nowhere = to_eigen(to_bullet(Pose()));
    CHECK(nowhere.orientation.coeffs() == Quat::Identity().coeffs());
}

TEST_CASE("a polyhedron's bounds are tight and it has no margin") {
    test::Random random(2);
    for (int i = 0; i < 20; ++i) {
        const auto exact = std::make_shared<const Shape>(random.polyhedron(12, 1e-3));
        const PolyhedronShape shape(exact);
        const auto& solid = std::get<ConvexPolyhedron>(*exact);
        CHECK(shape.getMargin() == 0);
        CHECK(shape.getNumPoints() == static_cast<int>(solid.vertices.size()));

        const Pose pose{random.vector(-1, 1), random.rotation()};
        btVector3 low, high;
        shape.getAabb(to_bullet(pose), low, high);
        Vec3 lowest = pose * solid.vertices.front();
        Vec3 highest = lowest;
        for (const Vec3& vertex : solid.vertices) {
            lowest = lowest.cwiseMin(pose * vertex);
            highest = highest.cwiseMax(pose * vertex);
        }
        CHECK((to_eigen(low) - lowest).norm() < 1e-15);
        CHECK((to_eigen(high) - highest).norm() < 1e-15);
    }
}

TEST_CASE("a polyhedron shape takes nothing but polyhedra, unscaled") {
    CHECK_THROWS_AS(PolyhedronShape(std::make_shared<const Shape>(Sphere{1})), std::invalid_argument);
    CHECK_THROWS_AS(PolyhedronShape(nullptr), std::invalid_argument);
    PolyhedronShape shape(std::make_shared<const Shape>(make_box(Vec3::Ones())));
    CHECK_NOTHROW(shape.setLocalScaling(btVector3(1, 1, 1)));
    CHECK_THROWS_AS(shape.setLocalScaling(btVector3(2, 1, 1)), std::invalid_argument);
}
