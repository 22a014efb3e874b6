#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include <scree/detect/body_shape.hpp>
#include <scree/detect/collision_shapes.hpp>
#include <scree/detect/convert.hpp>
#include <scree/mesh/mass_properties.hpp>
#include <tests/support/random.hpp>

using namespace scree;

namespace {

const ConvexPolyhedron& polyhedron(const BodyPart& part) {
    return std::get<ConvexPolyhedron>(*part.shape);
}

}  // namespace

TEST_CASE("a box has its margin inside") {
    ShapeLibrary library;
    const btBoxShape box(btVector3(0.5, 1, 1.5));
    const BodyShape shape = library.translate(box);
    REQUIRE(shape.parts.size() == 1);
    CHECK(shape.volume == Approx(6));
    const Bounds all = bounds(*shape.parts[0].shape, Pose());
    CHECK((all.high - Vec3(0.5, 1, 1.5)).norm() < 1e-15);
    CHECK(shape.radius == Approx(Vec3(0.5, 1, 1.5).norm()));
}

TEST_CASE("a hull is that of its scaled points, without margin") {
    ShapeLibrary library;
    test::Random random(3);
    const ConvexPolyhedron solid = random.polyhedron(10, 0.05);
    btConvexHullShape hull(solid.vertices.front().data(), static_cast<int>(solid.vertices.size()),
                           sizeof(Vec3));
    CHECK(library.translate(hull).volume == Approx(mass_properties(solid).volume));
    hull.setLocalScaling(btVector3(2, 1, 3));
    CHECK(library.translate(hull).volume == Approx(6 * mass_properties(solid).volume));
}

TEST_CASE("an exact polyhedron, a sphere and a plane are taken as they are") {
    ShapeLibrary library;
    const auto exact = std::make_shared<const Shape>(make_box(Vec3::Ones()));
    CHECK(library.translate(PolyhedronShape(exact)).parts[0].shape == exact);

    const BodyShape ball = library.translate(btSphereShape(0.3));
    CHECK(std::get<Sphere>(*ball.parts[0].shape).radius == 0.3);
    CHECK(ball.volume == Approx(4.0 / 3 * std::numbers::pi * 0.027));

    const BodyShape plane = library.translate(btStaticPlaneShape(btVector3(0, 0, 1), 0.25));
    CHECK(std::get<HalfSpace>(*plane.parts[0].shape).normal == Vec3::UnitZ());
    CHECK(std::get<HalfSpace>(*plane.parts[0].shape).offset == 0.25);
    CHECK(std::isinf(plane.volume));
}

TEST_CASE("capsules, cylinders and cones are solids of revolution along any of Bullet's axes, scaled") {
    ShapeLibrary library;
    const btVector3 scale(2, 2, 2);
    btCapsuleShape capsules[] = {btCapsuleShapeX(0.1, 0.4), btCapsuleShape(0.1, 0.4),
                                 btCapsuleShapeZ(0.1, 0.4)};
    btCylinderShapeX along_x(btVector3(0.3, 0.1, 0.1));
    btCylinderShape along_y(btVector3(0.1, 0.3, 0.1));
    btCylinderShapeZ along_z(btVector3(0.1, 0.1, 0.3));
    btCylinderShape* cylinders[] = {&along_x, &along_y, &along_z};
    btConeShapeX cone_x(0.1, 0.6);
    btConeShape cone_y(0.1, 0.6);
    btConeShapeZ cone_z(0.1, 0.6);
    btConeShape* cones[] = {&cone_x, &cone_y, &cone_z};
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool scaled : {false, true}) {
            const double factor = scaled ? 2 : 1;
            if (scaled) {
                capsules[axis].setLocalScaling(scale);
                cylinders[axis]->setLocalScaling(scale);
                cones[axis]->setLocalScaling(scale);
            }
            const BodyShape pill = library.translate(capsules[axis]);
            const auto& capsule = std::get<Capsule>(*pill.parts[0].shape);
            CHECK(capsule.radius == Approx(0.1 * factor));
            CHECK(capsule.half_length == Approx(0.2 * factor));
            const double ball = 4.0 / 3 * std::numbers::pi * 1e-3;
            CHECK(pill.volume == Approx(std::pow(factor, 3) * (ball + std::numbers::pi * 0.01 * 0.4)));
            CHECK(pill.radius == Approx(0.3 * factor));

            const BodyShape rod = library.translate(*cylinders[axis]);
            const auto& cylinder = std::get<Frustum>(*rod.parts[0].shape);
            CHECK(cylinder.bottom == Approx(0.1 * factor));
            CHECK(cylinder.top == cylinder.bottom);
            CHECK(cylinder.half_height == Approx(0.3 * factor));
            CHECK(rod.volume == Approx(std::pow(factor, 3) * std::numbers::pi * 0.01 * 0.6));

            const BodyShape hat = library.translate(*cones[axis]);
            const auto& cone = std::get<Frustum>(*hat.parts[0].shape);
            CHECK(cone.top == 0);
            CHECK(hat.volume == Approx(std::pow(factor, 3) * std::numbers::pi / 3 * 0.01 * 0.6));
            // The tip is where Bullet has it.
            const btVector3 up = cones[axis]->localGetSupportingVertexWithoutMargin(
                btVector3(axis == 0, axis == 1, axis == 2));
            CHECK((hat.parts[0].local * Vec3(0, 0, cone.half_height) - to_eigen(up)).norm() < 1e-12);
            for (const BodyShape* shape : {&pill, &rod, &hat}) {
                CHECK((shape->parts[0].local.orientation * Vec3::UnitZ() - Vec3::Unit(axis)).norm() < 1e-15);
            }
        }
    }
    CHECK(std::get<Sphere>(*library.translate(btCapsuleShape(0.2, 0)).parts[0].shape).radius == 0.2);
}

TEST_CASE("compounds give their parts where they are, nested ones too") {
    ShapeLibrary library;
    btBoxShape box(btVector3(0.5, 0.5, 0.5));
    btSphereShape ball(0.5);
    btCompoundShape inner, outer;
    const Pose one{Vec3(1, 0, 0), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ()))};
    const Pose other{Vec3(0, 2, 0), Quat(Eigen::AngleAxisd(0.7, Vec3::UnitX()))};
    inner.addChildShape(to_bullet(one), &box);
    outer.addChildShape(to_bullet(other), &inner);
    outer.addChildShape(to_bullet(other), &ball);
    const BodyShape shape = library.translate(outer);
    REQUIRE(shape.parts.size() == 2);
    CHECK((shape.parts[0].local.position - (other * one).position).norm() < 1e-15);
    CHECK(shape.parts[0].local.orientation.angularDistance((other * one).orientation) < 1e-15);
    CHECK(shape.volume == Approx(1 + 4.0 / 3 * std::numbers::pi / 8));
    CHECK(shape.radius == Approx((other * one).position.norm() + std::sqrt(0.75)));
}

TEST_CASE("equal parts are made once, whatever the Bullet shapes they come from") {
    ShapeLibrary library;
    const BodyShape first = library.translate(btBoxShape(btVector3(1, 2, 3)));
    const BodyShape second = library.translate(btBoxShape(btVector3(1, 2, 3)));
    const BodyShape third = library.translate(btBoxShape(btVector3(1, 2, 4)));
    CHECK(first.parts[0].shape == second.parts[0].shape);
    CHECK(first.parts[0].shape != third.parts[0].shape);
    for (int i = 1; i < 100; ++i) {  // shapes that come and go
        CHECK(polyhedron(library.translate(btBoxShape(btVector3(i, 1, 1))).parts[0]).face_count() == 6);
    }
    CHECK(library.translate(btBoxShape(btVector3(1, 2, 3))).parts[0].shape == first.parts[0].shape);
}

TEST_CASE("what has no overlap is refused by name") {
    ShapeLibrary library;
    const btVector3 centre(0, 0, 0);
    const btScalar one = 1;
    CHECK_THROWS_WITH(library.translate(btMultiSphereShape(&centre, &one, 1)),
                      Catch::Contains("MultiSphere"));
    CHECK_THROWS_WITH(library.translate(btConeShape(1, 0)), Catch::Contains("Cone"));
    CHECK_THROWS_WITH(library.translate(btCapsuleShape(-1, 1)), Catch::Contains("Capsule"));
    CHECK_THROWS_WITH(library.translate(btEmptyShape()), Catch::Contains("Empty"));
    CHECK_THROWS_AS(library.translate(btCompoundShape()), std::invalid_argument);
    CHECK_THROWS_AS(library.translate(btSphereShape(0)), std::invalid_argument);
    btConvexHullShape flat;
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
        flat.addPoint(btVector3(x, y, 0));
    }
    CHECK_THROWS_WITH(library.translate(flat), Catch::Contains("Convex"));
}
