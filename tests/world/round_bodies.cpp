#include <catch2/catch.hpp>

#include <cmath>

#include <tests/support/solids.hpp>
#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double mass = 1.3;
constexpr double radius = 0.05;
constexpr double gravity = 9.81;
const Quat lying = turned(M_PI / 2, Vec3::UnitX());

// A round body on a plane or on a box, whose top is at height 0.
struct Ground {
    BulletScene scene;
    btRigidBody& body;

    Ground(bool on_box, btCollisionShape& (*make)(BulletScene&), double height, const Quat& turn,
           double youngs_modulus, double slope = 0)
        : body(add(scene, on_box, make, height, turn, youngs_modulus)) {
        scene.world->setGravity(btVector3(gravity * std::sin(slope), 0, -gravity * std::cos(slope)));
        body.setGravity(scene.world->getGravity());
    }
    void run(double time) {
        for (int i = 0; i < static_cast<int>(std::lround(time / 0.01)); ++i) {
            scene.world->stepSimulation(0.01, 0);
        }
        INFO(scene.world->step_report().message);
        REQUIRE_FALSE(scene.world->step_report().failed);
    }
    [[nodiscard]] double iterations_a_step() const {
        const StepReport& report = scene.world->step_report();
        return static_cast<double>(report.steps.newton.iterations) /
               static_cast<double>(report.steps.accepted);
    }
    [[nodiscard]] double inertia(int axis) const { return 1 / body.getInvInertiaDiagLocal()[axis]; }

  private:
    static btRigidBody& add(BulletScene& scene, bool on_box, btCollisionShape& (*make)(BulletScene&),
                            double height, const Quat& turn, double youngs_modulus) {
        btRigidBody& floor =
            on_box ? scene.add(0, scene.box({20, 20, 1}), Vec3(0, 0, -0.5)) : scene.add_floor();
        btRigidBody& body = scene.add(mass, make(scene), Vec3(0.01, 0.02, height), turn);
        scene.world->set_material(floor, rock(youngs_modulus));
        scene.world->set_material(body, rock(youngs_modulus));
        return body;
    }
};

btCollisionShape& cylinder(BulletScene& scene) {
    return scene.shape<btCylinderShapeZ>(btVector3(radius, radius, 0.08));
}
btCollisionShape& cylinder_y(BulletScene& scene) {
    return scene.shape<btCylinderShape>(btVector3(radius, 0.08, radius));
}
btCollisionShape& coin(BulletScene& scene) {
    return scene.shape<btCylinderShapeZ>(btVector3(0.1, 0.1, 0.01));
}
btCollisionShape& cone(BulletScene& scene) {
    return scene.shape<btConeShapeZ>(radius, 0.12);
}
btCollisionShape& capsule(BulletScene& scene) {
    return scene.shape<btCapsuleShapeZ>(radius, 0.12);
}

}  // namespace

TEST_CASE("a cylinder and a cone stand on their ends, still, and sunk in as the law says") {
    const bool on_box = GENERATE(false, true);
    const double youngs_modulus = GENERATE(1e8, 1e10);
    for (const auto& [make, height, turn, volume] :
         {std::tuple(&cylinder, 0.08, Quat::Identity(), M_PI * radius * radius * 0.16),
          std::tuple(&cylinder_y, 0.08, lying, M_PI * radius * radius * 0.16),
          std::tuple(&cone, 0.06, Quat::Identity(), M_PI / 3 * radius * radius * 0.12)}) {
        Ground ground(on_box, make, height + 1e-4, turn, youngs_modulus);
        ground.run(1);
        const Vec3 before = position_of(ground.body);
        ground.run(1);
        CHECK((position_of(ground.body) - before).norm() < 1e-14);
        CHECK(ground.body.getLinearVelocity().length() < 1e-12);
        CHECK(ground.body.getAngularVelocity().length() < 1e-12);
        const double length = 2 * sphere_radius(volume);
        const double sunk = mass * gravity * length / (youngs_modulus * M_PI * radius * radius);
        CHECK(height - position_of(ground.body).z() == Approx(sunk).epsilon(1e-4));
        CHECK(ground.iterations_a_step() < 5);
    }
}

TEST_CASE("a coin that is dropped on its rim settles on its face") {
    Ground ground(GENERATE(false, true), &coin, 0.03, turned(0.05, Vec3(1, 0.3, 0)), 1e9);
    ground.run(2);
    CHECK(position_of(ground.body).z() == Approx(0.01).epsilon(1e-3));
    CHECK(ground.body.getLinearVelocity().length() < 1e-9);
    CHECK(ground.body.getAngularVelocity().length() < 1e-9);
    CHECK(ground.iterations_a_step() < 6);
}

TEST_CASE("a cylinder stands still on a slope below the angle of friction") {
    Ground ground(GENERATE(false, true), &cylinder, 0.08, turned(0.3, Vec3::UnitZ()), 1e9, 0.3);
    ground.run(1);
    const Vec3 before = position_of(ground.body);
    ground.run(1);
    CHECK((position_of(ground.body) - before).norm() < 1e-13);
}

TEST_CASE("a cylinder and a capsule lie still on their sides") {
    const bool on_box = GENERATE(false, true);
    for (const auto make : {&cylinder, &capsule}) {
        Ground ground(on_box, make, radius + 1e-4, turned(0.3, Vec3::UnitZ()) * lying, 1e9);
        ground.run(1);
        const Vec3 before = position_of(ground.body);
        ground.run(1);
        CHECK((position_of(ground.body) - before).norm() < 1e-12);
        CHECK(ground.body.getAngularVelocity().length() < 1e-10);
        CHECK(ground.iterations_a_step() < 3);
    }
}

TEST_CASE("a cylinder and a capsule that roll go on rolling") {
    const bool on_box = GENERATE(false, true);
    for (const auto make : {&cylinder, &capsule}) {
        Ground ground(on_box, make, radius - 2e-6, lying, 1e10);
        ground.body.setLinearVelocity(btVector3(1, 0, 0));
        ground.body.setAngularVelocity(btVector3(0, 1 / radius, 0));
        ground.run(0.5);
        const Vec3 start = position_of(ground.body);
        const double speed = ground.body.getLinearVelocity().x();
        ground.run(2);
        CHECK(speed == Approx(1).epsilon(1e-4));
        CHECK(ground.body.getLinearVelocity().x() == Approx(speed).epsilon(1e-7));
        CHECK(position_of(ground.body).x() - start.x() == Approx(2 * speed).epsilon(1e-6));
        CHECK(std::abs(position_of(ground.body).y() - start.y()) < 1e-8);
        CHECK(ground.iterations_a_step() < 3);
    }
}

TEST_CASE("round bodies roll down a slope at g sin θ/(1 + I/(m R²))") {
    const bool on_box = GENERATE(false, true);
    const double slope = 0.2;
    for (const auto make : {&cylinder, &capsule}) {
        Ground ground(on_box, make, radius - 2e-6, lying, 1e10, slope);
        ground.run(1);
        const double share = 1 + ground.inertia(2) / (mass * radius * radius);
        const double expected = gravity * std::sin(slope) / share;
        CHECK(ground.body.getLinearVelocity().x() == Approx(expected).epsilon(1e-4));
        CHECK(ground.body.getAngularVelocity().y() == Approx(expected / radius).epsilon(1e-3));
        CHECK(std::abs(ground.body.getLinearVelocity().y()) < 1e-7);
    }
}

TEST_CASE("round bodies rest on one another") {
    BulletScene scene;
    std::vector<btRigidBody*> bodies{&scene.add_floor()};
    // A wall of cylinders on end, and a capsule in the groove of two others that are held.
    for (int i = 0; i < 3; ++i) {
        bodies.push_back(&scene.add(1, cylinder(scene), Vec3(-1, 0, 0.08 + 0.16 * i), turned(i, {0, 0, 1})));
    }
    for (const double side : {-0.04, 0.04}) {
        bodies.push_back(&scene.add(0, capsule(scene), Vec3(1 + side, 0, radius), lying));
    }
    const double height = radius + std::sqrt(4 * radius * radius - 0.04 * 0.04);
    bodies.push_back(&scene.add(1, capsule(scene), Vec3(1, 0, height), lying));
    for (btRigidBody* body : bodies) {
        scene.world->set_material(*body, rock(1e9));
    }
    for (int i = 0; i < 100; ++i) {
        scene.world->stepSimulation(0.01, 0);
    }
    INFO(scene.world->step_report().message);
    REQUIRE_FALSE(scene.world->step_report().failed);
    for (const btRigidBody* body : bodies) {
        CHECK(body->getLinearVelocity().length() < 1e-6);
        CHECK(body->getAngularVelocity().length() < 1e-5);
    }
    CHECK(position_of(*bodies[3]).z() == Approx(0.4).epsilon(1e-4));
    CHECK(position_of(*bodies[6]).z() == Approx(height).epsilon(1e-3));
    CHECK(scene.world->step_report().contacts == 5);
}
