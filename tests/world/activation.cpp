#include <catch2/catch.hpp>

#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

void let_sleep(BulletScene& scene) {
    SteppingOptions options;
    options.sleep = true;
    scene.world->set_stepping(options);
}

// Steps that the world has made since last asked.
std::size_t steps_since(const BulletScene& scene, std::size_t& before) {
    const std::size_t now = scene.world->step_report().all_steps.accepted;
    return now - std::exchange(before, now);
}

}  // namespace

TEST_CASE("with the option on, what rests sleeps, and costs nothing") {
    BulletScene scene;
    let_sleep(scene);
    scene.add_floor();
    btRigidBody& cube = add_cube(scene, 0, 0.05);
    btRigidBody& falling = add_cube(scene, 1, 30);
    step(scene, 150);
    CHECK(cube.getActivationState() == ISLAND_SLEEPING);
    CHECK_FALSE(cube.isActive());
    CHECK(falling.getActivationState() == ACTIVE_TAG);
    scene.destroy(falling);
    step(scene, 1);
    std::size_t before = 0;
    steps_since(scene, before);
    const double height = position_of(cube).z();
    step(scene, 20);
    CHECK(steps_since(scene, before) == 0);
    CHECK(position_of(cube).z() == height);
    CHECK(scene.world->step_report().contacts == 1);
}

TEST_CASE("a sleeper wakes up") {
    BulletScene scene;
    let_sleep(scene);
    constexpr double soft = 1e8;  // [Pa]: what falls on the cube is still at it after 0.3 s
    btRigidBody& slab = scene.add(0, scene.box(Vec3(4, 4, 0.1)), Vec3(0, 0, -0.05));
    btRigidBody& cube = add_cube(scene, 0, 0.05, soft);
    step(scene, 150);
    REQUIRE(cube.getActivationState() == ISLAND_SLEEPING);
    SECTION("when it is activated") {
        cube.activate();
        step(scene, 1);
        CHECK(cube.getActivationState() == ACTIVE_TAG);
    }
    SECTION("when it is pushed") {
        cube.applyCentralImpulse(btVector3(1, 0, 0));
        step(scene, 1);
        CHECK(cube.getActivationState() == ACTIVE_TAG);
        CHECK(position_of(cube).x() > 0.005);
    }
    SECTION("when a force acts on it") {
        cube.applyCentralForce(btVector3(0, 0, 20));
        step(scene, 1);
        CHECK(cube.getLinearVelocity().z() > 0.05);
    }
    SECTION("when something comes") {
        add_cube(scene, 0, 0.2, soft);
        step(scene, 30);
        CHECK(scene.world->step_report().contacts == 2);
        CHECK(cube.isActive());
        step(scene, 200);
        CHECK_FALSE(cube.isActive());
    }
    SECTION("when what it stands on goes or is moved") {
        if (GENERATE(true, false)) {
            scene.destroy(slab);
        } else {
            slab.setWorldTransform(to_bullet(Pose{Vec3(0, 0, -1), Quat::Identity()}));
        }
        step(scene, 10);
        CHECK(cube.isActive());
        CHECK(position_of(cube).z() < 0.01);
    }
    SECTION("when it is not to be deactivated") {
        cube.setActivationState(DISABLE_DEACTIVATION);
        step(scene, 50);
        CHECK(cube.getActivationState() == DISABLE_DEACTIVATION);
    }
}

TEST_CASE("a body that may not be deactivated keeps what touches it awake") {
    BulletScene scene;
    let_sleep(scene);
    scene.add_floor();
    btRigidBody& lower = add_cube(scene, 0, 0.05);
    btRigidBody& upper = add_cube(scene, 0, 0.15);
    btRigidBody& alone = add_cube(scene, 1, 0.05);
    upper.setActivationState(DISABLE_DEACTIVATION);
    step(scene, 150);
    CHECK(lower.isActive());
    CHECK(upper.getActivationState() == DISABLE_DEACTIVATION);
    CHECK_FALSE(alone.isActive());
}

TEST_CASE("without the option only those sleep that want to") {
    BulletScene scene;
    scene.add_floor();
    btRigidBody& one = add_cube(scene, 0, 0.05);
    btRigidBody& other = add_cube(scene, 1, 0.05);
    one.setActivationState(WANTS_DEACTIVATION);
    step(scene, 150);
    CHECK(one.getActivationState() == ISLAND_SLEEPING);
    CHECK(other.getActivationState() == ACTIVE_TAG);
}

TEST_CASE("bodies put to sleep hang where they are until somebody comes") {
    BulletScene scene;
    std::vector<btRigidBody*> wall;
    for (int i = 0; i < 4; ++i) {
        wall.push_back(&add_cube(scene, 0, 1 + 0.1 * i));
        wall.back()->forceActivationState(ISLAND_SLEEPING);
    }
    btRigidBody& moving = add_cube(scene, 3, 5);
    step(scene, 5);
    moving.forceActivationState(ISLAND_SLEEPING);  // in the middle of its fall
    const double height = position_of(moving).z();
    step(scene, 20);
    for (int i = 0; i < 4; ++i) {
        CHECK(position_of(*wall[static_cast<std::size_t>(i)]).z() == 1 + 0.1 * i);
        CHECK(wall[static_cast<std::size_t>(i)]->getActivationState() == ISLAND_SLEEPING);
    }
    CHECK(position_of(moving).z() == height);
    CHECK(moving.getLinearVelocity().length() == 0);

    btRigidBody& ball = add_cube(scene, -1, 1.2);
    ball.setLinearVelocity(btVector3(10, 0, 0));
    step(scene, 20);
    CHECK(wall[2]->isActive());
    CHECK((position_of(*wall[2]) - Vec3(0, 0, 1.2)).norm() > 0.02);
    CHECK(position_of(moving).z() == height);
}

TEST_CASE("one body of a group that is put to sleep sleeps no more than the others") {
    BulletScene scene;
    scene.add_floor();
    btRigidBody& lower = add_cube(scene, 0, 0.05);
    btRigidBody& upper = add_cube(scene, 0, 0.151);
    upper.forceActivationState(ISLAND_SLEEPING);
    step(scene, 5);
    CHECK(upper.getActivationState() == ACTIVE_TAG);
    CHECK(lower.getActivationState() == ACTIVE_TAG);
    CHECK(position_of(upper).z() < 0.151);
}

TEST_CASE("what moves as prescribed wakes what it comes to") {
    BulletScene scene;
    let_sleep(scene);
    scene.add_floor();
    btRigidBody& cube = add_cube(scene, 0, 0.05);
    btRigidBody& pusher = scene.make(0, scene.box(Vec3::Constant(0.1)), Vec3(-0.5, 0, 0.06));
    pusher.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    scene.world->addRigidBody(&pusher);
    step(scene, 150);
    REQUIRE_FALSE(cube.isActive());
    for (int i = 0; i < 60; ++i) {
        btTransform place = pusher.getWorldTransform();
        place.getOrigin() += btVector3(0.01, 0, 0);
        pusher.setWorldTransform(place);
        step(scene, 1);
    }
    CHECK(cube.isActive());
    CHECK(position_of(cube).x() == Approx(0.2).margin(5e-3));
}
