#include <catch2/catch.hpp>

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>

#include <cmath>

#include <tests/support/solids.hpp>
#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double edge = 0.1;
constexpr double mass = 1.3;
constexpr double gravity = 9.81;
constexpr double youngs_modulus = 1e8;

void slope(BulletScene& scene, double angle) {
    scene.world->setGravity(btVector3(gravity * std::sin(angle), 0, -gravity * std::cos(angle)));
}

void make_of(BulletScene& scene, const std::vector<btRigidBody*>& bodies) {
    for (const btRigidBody* body : bodies) {
        scene.world->set_material(*body, rock(youngs_modulus));
    }
}

int manifold_points(BulletScene& scene) {
    int sum = 0;
    for (int i = 0; i < scene.dispatcher.getNumManifolds(); ++i) {
        sum += scene.dispatcher.getManifoldByIndexInternal(i)->getNumContacts();
    }
    return sum;
}

// A floor of triangles of a metre, or of a finer height field, at height 0.
struct Terrain {
    btTriangleMesh mesh;
    std::vector<double> heights = std::vector<double>(41 * 41, 0.0);
    std::unique_ptr<btConcaveShape> shape;

    explicit Terrain(bool field) {
        if (field) {
            shape = std::make_unique<btHeightfieldTerrainShape>(41, 41, heights.data(), 1, -1, 1, 2,
                                                                PHY_DOUBLE, false);
            shape->setLocalScaling(btVector3(0.5, 0.5, 1));
        } else {
            for (int i = -10; i < 10; ++i) {
                for (int j = -10; j < 10; ++j) {
                    const btVector3 a(i, j, 0), b(i + 1, j, 0), c(i + 1, j + 1, 0), d(i, j + 1, 0);
                    mesh.addTriangle(a, b, c);
                    mesh.addTriangle(a, c, d);
                }
            }
            shape = std::make_unique<btBvhTriangleMeshShape>(&mesh, true);
        }
        shape->setMargin(0);
    }
};

}  // namespace

TEST_CASE("by Bullet's manifolds a cube sinks in by m g/(Y Lc), on a plane and on a slab") {
    const bool on_plane = GENERATE(true, false);
    const bool hull = GENERATE(true, false);
    BulletScene scene;
    scene.world->set_contact_geometry(GeometrySource::manifold);
    btRigidBody& floor = on_plane
                             ? scene.add_floor()
                             : scene.add(0, scene.shape<btBoxShape>(btVector3(5, 5, 0.5)), Vec3(0, 0, -0.5));
    btCollisionShape& shape = hull ? static_cast<btCollisionShape&>(scene.box(Vec3::Constant(edge)))
                                   : scene.shape<btBoxShape>(btVector3(edge / 2, edge / 2, edge / 2));
    btRigidBody& box = scene.add(mass, shape, Vec3(0.3, 0.2, edge / 2 + 1e-3));
    make_of(scene, {&floor, &box});
    run(scene, 2, 0.01);
    const double length = 2 * sphere_radius(edge * edge * edge);
    const double sunk = mass * gravity / (youngs_modulus * length);
    CHECK(edge / 2 - position_of(box).z() == Approx(sunk).epsilon(0.4));  // corners may share it unevenly
    CHECK(box.getLinearVelocity().length() < 1e-3);
    CHECK((position_of(box) - Vec3(0.3, 0.2, edge / 2)).norm() < 3e-3);
    CHECK(manifold_points(scene) > 0);
    CHECK(scene.world->step_report().contacts == 1);
}

TEST_CASE("by Bullet's manifolds a block holds on a slope below the angle of friction and slides above it") {
    for (const double angle : {0.3, 0.6}) {
        BulletScene scene;
        scene.world->set_contact_geometry(GeometrySource::manifold);
        slope(scene, angle);
        btRigidBody& floor = scene.add(0, scene.shape<btBoxShape>(btVector3(9, 9, 0.5)), Vec3(0, 0, -0.5));
        btRigidBody& box = scene.add(mass, scene.box(Vec3::Constant(edge)), Vec3(0, 0, edge / 2));
        make_of(scene, {&floor, &box});
        run(scene, 0.5, 0.01);
        const double speed = box.getLinearVelocity().x();
        run(scene, 0.5, 0.01);
        const double slide = gravity * (std::sin(angle) - 0.5 * std::cos(angle));
        const double gained = box.getLinearVelocity().x() - speed;
        CHECK(gained == Approx(angle < 0.46 ? 0 : 0.5 * slide).epsilon(0.05).margin(0.01));
    }
}

TEST_CASE("by Bullet's manifolds balls and cylinders roll") {
    for (const bool ball : {true, false}) {
        BulletScene scene;
        scene.world->set_contact_geometry(GeometrySource::manifold);
        slope(scene, 0.2);
        btRigidBody& floor = scene.add_floor();
        btCollisionShape& shape = ball ? static_cast<btCollisionShape&>(scene.shape<btSphereShape>(0.05))
                                       : scene.shape<btCylinderShapeZ>(btVector3(0.05, 0.05, 0.08));
        btRigidBody& body = scene.add(mass, shape, Vec3(0, 0, 0.05), turned(M_PI / 2, Vec3::UnitX()));
        make_of(scene, {&floor, &body});
        run(scene, 1, 0.01);
        const double share = ball ? 1.4 : 1.5;
        CHECK(body.getLinearVelocity().x() == Approx(gravity * std::sin(0.2) / share).epsilon(0.01));
    }
}

TEST_CASE("by Bullet's manifolds nothing passes a thin plate between two ticks") {
    BulletScene scene;
    scene.world->set_contact_geometry(GeometrySource::manifold);
    scene.world->setGravity(btVector3(0, 0, 0));
    btRigidBody& plate = scene.add(0, scene.shape<btBoxShape>(btVector3(1, 1, 0.005)), Vec3(0, 0, 0));
    btRigidBody& ball = scene.add(0.1, scene.shape<btSphereShape>(0.02), Vec3(0, 0, 0.3));
    btRigidBody& box = scene.add(0.1, scene.box(Vec3::Constant(0.04)), Vec3(0.5, 0, 0.3));
    make_of(scene, {&plate, &ball, &box});
    for (btRigidBody* body : {&ball, &box}) {
        body->setLinearVelocity(btVector3(0, 0, -50));
    }
    run(scene, 0.1, 0.01);
    CHECK(position_of(ball).z() > 0);
    CHECK(position_of(box).z() > 0);
    CHECK(ball.getLinearVelocity().z() > 0);
    CHECK(box.getLinearVelocity().z() > 0);
}

TEST_CASE("bodies rest and roll on meshes of triangles and height fields, whatever the source of geometry") {
    const bool field = GENERATE(false, true);
    const bool manifold = GENERATE(false, true);
    Terrain terrain(field);
    BulletScene scene;
    if (manifold) {
        scene.world->set_contact_geometry(GeometrySource::manifold);
    }
    btRigidBody& ground = scene.add(0, *terrain.shape, Vec3::Zero());
    btRigidBody& box = scene.add(mass, scene.box(Vec3::Constant(edge)), Vec3(0.3, 0.2, edge / 2 + 1e-3));
    btRigidBody& top = scene.add(mass, scene.box(Vec3::Constant(edge)), Vec3(0.3, 0.2, 1.5 * edge + 2e-3));
    btRigidBody& ball = scene.add(mass, scene.shape<btSphereShape>(0.05), Vec3(-2, 0.2, 0.051));
    btRigidBody& rod = scene.add(mass, scene.shape<btCapsuleShapeZ>(0.05, 0.1), Vec3(2, 0.2, 0.051),
                                 turned(M_PI / 2, Vec3::UnitX()));
    make_of(scene, {&ground, &box, &top, &ball, &rod});
    run(scene, 1.5, 0.01);
    CHECK(position_of(box).z() == Approx(edge / 2).margin(2e-4));
    CHECK(position_of(top).z() == Approx(1.5 * edge).margin(4e-4));
    CHECK(position_of(ball).z() == Approx(0.05).margin(2e-4));
    CHECK(position_of(rod).z() == Approx(0.05).margin(2e-4));
    for (const btRigidBody* body : {&box, &top, &ball, &rod}) {
        CHECK(body->getLinearVelocity().length() < 5e-3);
    }
    CHECK(scene.world->step_report().contacts == 4);
    CHECK(manifold_points(scene) > 6);
    ball.setLinearVelocity(btVector3(0.5, 0, 0));
    run(scene, 1, 0.01);
    CHECK(position_of(ball).x() > -1.75);
    scene.destroy(box);
    run(scene, 0.05, 0.01);
    scene.world->removeRigidBody(&ground);
    CHECK(manifold_points(scene) == 0);
    run(scene, 0.2, 0.01);
    CHECK(position_of(ball).z() < 0);
    scene.world->addRigidBody(&ground);
}

TEST_CASE("a hull's margin counts where Bullet's manifold does") {
    BulletScene scene;
    scene.world->set_contact_geometry(GeometrySource::manifold);
    btRigidBody& floor = scene.add_floor();
    btConvexHullShape& hull = scene.shape<btConvexHullShape>();
    for (int i = 0; i < 8; ++i) {
        hull.addPoint(btVector3(i & 1 ? 0.1 : -0.1, i & 2 ? 0.1 : -0.1, i & 4 ? 0.1 : -0.1));
    }
    hull.setMargin(0.02);
    btRigidBody& box = scene.add(mass, hull, Vec3(0, 0, 0.16));
    make_of(scene, {&floor, &box});
    run(scene, 1, 0.01);
    CHECK(position_of(box).z() == Approx(0.12).margin(2e-4));
}

TEST_CASE("surfaces that are open cannot move by forces") {
    Terrain terrain(false);
    BulletScene scene;
    btRigidBody& body = scene.make(1, scene.box(Vec3::Ones()), Vec3::Zero());
    body.setCollisionShape(terrain.shape.get());
    CHECK_THROWS_WITH(scene.world->addRigidBody(&body), Catch::Contains("mesh of triangles"));
    CHECK(scene.world->getNumCollisionObjects() == 0);
}

TEST_CASE("the source of geometry may change while running, and explicit methods take either") {
    BulletScene scene;
    SteppingOptions options;
    options.method = Method::velocity_verlet;
    options.fixed_step = 1e-5;
    scene.world->set_stepping(options);
    btRigidBody& floor = scene.add_floor();
    btRigidBody& box = scene.add(mass, scene.box(Vec3::Constant(edge)), Vec3(0, 0, edge / 2 + 1e-4));
    for (const btRigidBody* body : {&floor, &box}) {
        scene.world->set_material(*body, rock(1e7));
    }
    run(scene, 0.1, 0.01);
    const int with_overlap = manifold_points(scene);
    CHECK(with_overlap == 4);
    scene.world->set_contact_geometry(GeometrySource::manifold);
    CHECK(scene.world->system().contacts.empty());
    run(scene, 0.3, 0.01);
    const double length = 2 * sphere_radius(edge * edge * edge);
    CHECK(edge / 2 - position_of(box).z() == Approx(mass * gravity / (1e7 * length)).epsilon(0.2));
    scene.world->set_contact_geometry(GeometrySource::overlap);
    run(scene, 0.3, 0.01);
    CHECK(edge / 2 - position_of(box).z() ==
          Approx(mass * gravity * length / (1e7 * edge * edge)).epsilon(0.02));
}
