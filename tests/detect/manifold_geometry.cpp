#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

#include <scree/detect/collision_shapes.hpp>
#include <scree/detect/convert.hpp>
#include <scree/detect/manifold_geometry.hpp>
#include <tests/support/solids.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double area = 0.01;

// Two objects that are in no world, and Bullet's narrowphase between them.
struct Pair {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDispatcherInfo info;
    ShapeLibrary library;
    btCollisionObject a, b;
    std::unique_ptr<ManifoldGeometry> geometry;

    Pair(btCollisionShape& shape_a, btCollisionShape& shape_b) {
        a.setCollisionShape(&shape_a);
        b.setCollisionShape(&shape_b);
        b.setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
        geometry = std::make_unique<ManifoldGeometry>(
            dispatcher, ManifoldGeometry::Side{&a, library.translate(shape_a).parts[0], 0},
            ManifoldGeometry::Side{&b, library.translate(shape_b).parts[0], 0});
    }
    void update(const Pose& pose_a, const Pose& pose_b, double reach,
                double growth = std::numeric_limits<double>::infinity()) {
        geometry->update({pose_a, pose_b, reach, area, growth}, info);
    }
    std::optional<ContactGeometry> meet(const Pose& pose_a, const Pose& pose_b) {
        OverlapWorkspace workspace;
        ContactGeometry g;
        if (!geometry->geometry(pose_a, pose_b, Detail::force, false, workspace, g)) {
            return std::nullopt;
        }
        return g;
    }
};

Pose above(double height) {
    return {{0.1, 0.2, height}, Quat::Identity()};
}

}  // namespace

TEST_CASE("a body that comes down finds the points where it will touch") {
    btBoxShape box(btVector3(0.5, 0.5, 0.5));
    PolyhedronShape hull(std::make_shared<const Shape>(make_box(Vec3::Ones())));
    btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
    btBoxShape slab(btVector3(5, 5, 0.5));
    for (btCollisionShape* shape :
         {static_cast<btCollisionShape*>(&box), static_cast<btCollisionShape*>(&hull)}) {
        for (const bool on_plane : {true, false}) {
            Pair pair(*shape, on_plane ? static_cast<btCollisionShape&>(plane) : slab);
            const Pose ground{{0, 0, on_plane ? 0.0 : -0.5}, Quat::Identity()};
            CAPTURE(shape->getName(), on_plane);
            pair.update(above(0.7), ground, 0.1);
            CHECK_FALSE(pair.meet(above(0.4), ground).has_value());  // it was too far off
            pair.update(above(0.55), ground, 0.1);
            CHECK_FALSE(pair.meet(above(0.55), ground).has_value());
            const auto g = pair.meet(above(0.499), ground);
            REQUIRE(g.has_value());
            // All four corners at once, each with its share.
            CHECK(g->depth == Approx(1e-3).epsilon(1e-3));
            CHECK(g->volume == Approx(area * 1e-3).epsilon(1e-3));
            CHECK(g->lever == Approx(std::sqrt(0.5)).epsilon(1e-2));
            CHECK(g->normal.z() == Approx(1));
        }
    }
}

TEST_CASE("objects stay where they are while their narrowphase is run elsewhere") {
    btSphereShape ball(0.5);
    btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
    Pair pair(ball, plane);
    pair.a.setWorldTransform(to_bullet(above(7)));
    pair.update(above(0.49), Pose(), 0.1);
    CHECK(pair.a.getWorldTransform().getOrigin().z() == 7);
    CHECK(pair.meet(above(0.49), Pose()).has_value());
    REQUIRE(pair.geometry->manifold() != nullptr);
    CHECK(pair.geometry->manifold()->getNumContacts() == 1);
    CHECK(pair.geometry->concerns(pair.a));
    pair.geometry->release();
    CHECK(pair.dispatcher.getNumManifolds() == 0);
    CHECK(pair.meet(above(0.49), Pose()).has_value());
}

TEST_CASE("a ball rolls on under its point, and has one whichever way Bullet orders the two") {
    btSphereShape ball(0.5);
    btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
    for (const bool ball_first : {true, false}) {
        Pair pair(ball_first ? static_cast<btCollisionShape&>(ball) : plane,
                  ball_first ? static_cast<btCollisionShape&>(plane) : ball);
        const auto both = [&](const Pose& pose, auto&& work) {
            return ball_first ? work(pose, Pose()) : work(Pose(), pose);
        };
        for (int i = 0; i < 5; ++i) {
            const Pose pose{{0.1 * i, 0, 0.499}, turned(0.2 * i, Vec3::UnitY())};
            both(pose, [&](const Pose& a, const Pose& b) {
                pair.update(a, b, 0.1);
                return 0;
            });
            const Pose later{{0.1 * i + 0.05, 0, 0.499}, turned(0.2 * i + 0.1, Vec3::UnitY())};
            const auto g = both(later, [&](const Pose& a, const Pose& b) { return pair.meet(a, b); });
            REQUIRE(g.has_value());
            CHECK(std::abs(g->normal.z()) == Approx(1));
            // The ball came into being sunk in: the slack goes from update to update.
            CHECK(g->depth == Approx(1e-3 * (1 - std::pow(0.9, i + 1))).epsilon(1e-6));
            CHECK((g->centroid + (ball_first ? later.position : Vec3::Zero())).x() ==
                  Approx(later.position.x()));
        }
    }
}

TEST_CASE("depth that was found and not pressed in becomes load little by little") {
    btSphereShape ball(0.5);
    btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
    Pair pair(ball, plane);
    double before = 0;
    for (int i = 0; i < 100; ++i) {
        pair.update(above(0.49), Pose(), 0.1);
        const double depth = pair.meet(above(0.49), Pose()).value().depth;
        CHECK(depth > before);
        CHECK((i > 0 || depth == Approx(1e-3)));
        before = depth;
    }
    CHECK(before == Approx(0.01).epsilon(1e-3));
}

TEST_CASE("a load grows by no more than it may in one update") {
    btSphereShape ball(0.5);
    btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
    Pair pair(ball, plane);
    for (int i = 1; i < 10; ++i) {
        constexpr double growth = 1e-5;
        pair.update(above(0.49), Pose(), 0.1, growth);
        CHECK(pair.meet(above(0.49), Pose()).value().depth == Approx(i * growth));
    }
}

TEST_CASE("flat triangles ahead are no wall, a step is one") {
    btTriangleMesh mesh;
    const auto quad = [&mesh](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        mesh.addTriangle(to_bullet(a), to_bullet(b), to_bullet(c));
        mesh.addTriangle(to_bullet(a), to_bullet(c), to_bullet(d));
    };
    for (int i = -3; i < 3; ++i) {
        quad(Vec3(i, -3, 0), Vec3(i + 1, -3, 0), Vec3(i + 1, 3, 0), Vec3(i, 3, 0));
    }
    quad({3, -3, 0}, {3, 3, 0}, {3, 3, 2}, {3, -3, 2});
    btBvhTriangleMeshShape ground(&mesh, true);
    ground.setMargin(0);
    btBoxShape box(btVector3(0.5, 0.5, 0.5));
    Pair pair(box, ground);
    const auto at = [](double x, double z) -> Pose { return {{x, 0, z}, Quat::Identity()}; };
    pair.update(at(0.3, 0.501), Pose(), 0.5);
    const auto slid = pair.meet(at(0.7, 0.5005), Pose());
    CHECK_FALSE(slid.has_value());
    const auto sunk = pair.meet(at(0.7, 0.4995), Pose()).value();
    CHECK(sunk.normal.z() == Approx(1).epsilon(1e-9));
    pair.update(at(2.3, 0.52), Pose(), 0.5);
    const auto wall = pair.meet(at(2.51, 0.52), Pose());
    REQUIRE(wall.has_value());
    CHECK(wall->normal.x() == Approx(-1).epsilon(1e-9));
}
