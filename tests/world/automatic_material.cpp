#include <catch2/catch.hpp>

#include <cmath>

#include <scree/world/automatic_material.hpp>
#include <tests/support/random.hpp>
#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// A mass on a spring and a dashpot that cannot pull, let go at speed 1: its speed when the force ends.
double bounced_speed(double damping_ratio) {
    const double step = 1e-5;
    double x = 0;
    double v = 1;
    while (true) {  // classical Runge–Kutta
        const auto force = [&](double at, double speed) { return -at - 2 * damping_ratio * speed; };
        const double k1 = force(x, v);
        const double k2 = force(x + 0.5 * step * v, v + 0.5 * step * k1);
        const double k3 = force(x + 0.5 * step * (v + 0.5 * step * k1), v + 0.5 * step * k2);
        const double k4 = force(x + step * (v + 0.5 * step * k2), v + step * k3);
        x += step * (v + step / 6 * (k1 + k2 + k3));
        v += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        if (force(x, v) >= 0 && v < 0) {
            return -v;
        }
    }
}

}  // namespace

TEST_CASE("restitution follows the spring and dashpot that cannot pull") {
    CHECK(restitution(0) == 1);
    CHECK(restitution(0.05) == Approx(0.858758).epsilon(1e-6));
    CHECK(restitution(0.2) == Approx(0.571740).epsilon(1e-6));
    CHECK(restitution(0.5) == Approx(0.298436).epsilon(1e-5));
    CHECK(restitution(0.8) == Approx(0.179783).epsilon(1e-5));
    CHECK(restitution(1) == Approx(std::exp(-2)));
    for (const double ratio : {0.05, 0.3, 0.7, 0.95}) {
        CHECK(restitution(ratio) == Approx(bounced_speed(ratio)).epsilon(1e-4));
        CHECK(damping_ratio(restitution(ratio)) == Approx(ratio).epsilon(1e-12));
    }
    CHECK(damping_ratio(0) == 1);
    CHECK(damping_ratio(1) == 0);
    CHECK(damping_ratio(1.5) == 0);
}

TEST_CASE("a resting shape's volume below ground is that of its least face or cap") {
    const double depth = 1e-4;
    CHECK(resting_volume(make_box(Vec3(1, 2, 3)), depth) == Approx(2 * depth));
    const double cap = M_PI * depth * depth * (0.5 - depth / 3);
    CHECK(resting_volume(Sphere{0.5}, depth) == Approx(cap));
    CHECK(std::isinf(resting_volume(HalfSpace{}, depth)));
}

TEST_CASE("a body without material sinks in by no more than a ten-thousandth of its size") {
    Random random(4);
    const int kind = GENERATE(0, 1, 2);
    BulletScene scene;
    scene.add_floor();
    btCollisionShape* shape = nullptr;
    double radius = 0.05;
    if (kind == 0) {
        shape = &scene.box(Vec3(0.04, 0.1, 0.2));
        radius = sphere_radius(0.04 * 0.1 * 0.2);
    } else if (kind == 1) {
        shape = &scene.shape<btSphereShape>(radius);
    } else {
        shape = &scene.box(Vec3::Constant(0.1));
        radius = sphere_radius(1e-3);
    }
    btRigidBody& body = scene.add(3, *shape, Vec3(0, 0, kind == 0 ? 0.1 : 0.05));
    for (int i = 0; i < 200; ++i) {
        scene.world->stepSimulation(0.01, 1, 0.01);
    }
    REQUIRE_FALSE(scene.world->step_report().failed);
    REQUIRE(scene.world->step_report().contacts == 1);
    const double sunk = scene.world->contact_results()[0].depth;
    CHECK(sunk <= 1e-4 * radius * (1 + 1e-3));
    CHECK(sunk > 1e-5 * radius);
    CHECK(body.getLinearVelocity().length() < 1e-6);
}

TEST_CASE("a material is derived from what Bullet has, and can be asked for") {
    BulletScene scene;
    btRigidBody& floor = scene.add_floor();
    btRigidBody& body = scene.make(2, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 1));
    CHECK_THROWS_AS(scene.world->material(body), std::invalid_argument);
    body.setFriction(0.7);
    body.setRestitution(0.571740);
    scene.world->addRigidBody(&body);
    const Material derived = scene.world->material(body);
    CHECK(derived.friction == 0.7);
    CHECK(derived.normal_damping == Approx(0.4).epsilon(1e-5));
    CHECK(derived.density == Approx(2000));
    CHECK(std::isfinite(derived.youngs_modulus));
    CHECK(std::isinf(scene.world->material(floor).youngs_modulus));

    scene.world->set_material(body, rock(3e9));
    CHECK(scene.world->material(body).youngs_modulus == 3e9);
}
