#include <catch2/catch.hpp>

#include <cmath>

#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// A motion that is a function of time, for stepSimulation to ask for.
class Path : public btMotionState {
  public:
    std::function<Pose(double)> at;
    double time = 0;
    void getWorldTransform(btTransform& transform) const override { transform = to_bullet(at(time)); }
    void setWorldTransform(const btTransform& /*transform*/) override { FAIL("a kinematic body is not set"); }
};

btRigidBody& add_kinematic(BulletScene& scene, btCollisionShape& shape, Path& path) {
    btRigidBody& body = scene.make(0, shape, path.at(0).position, path.at(0).orientation);
    body.setMotionState(&path);
    body.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    scene.world->addRigidBody(&body);
    return body;
}

// Ticks of which several make one call; the path is set to the call's end, as Bullet wants it.
void run(BulletScene& scene, Path& path, int calls, int ticks, double tick) {
    for (int i = 0; i < calls; ++i) {
        path.time += ticks * tick;
        CHECK(scene.world->stepSimulation(ticks * tick * (1 + 1e-12), ticks, tick) == ticks);
        INFO(scene.world->step_report().message);
        REQUIRE_FALSE(scene.world->step_report().failed);
    }
}

}  // namespace

TEST_CASE("a kinematic body is where its motion leads at the end of each call") {
    BulletScene scene;
    Path path;
    path.at = [](double t) -> Pose {
        return {Vec3(std::sin(t), t * t, 0), Quat(Eigen::AngleAxisd(3 * t, Vec3(1, 2, 2) / 3))};
    };
    btRigidBody& body = add_kinematic(scene, scene.box(Vec3::Constant(0.2)), path);
    scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(5, 0, 0));
    run(scene, path, 20, 5, 0.01);
    const BodyState& state =
        scene.world->system().states[static_cast<std::size_t>(scene.world->body_number(body))];
    CHECK((state.position - path.at(1).position).norm() < 1e-13);
    CHECK(state.orientation.angularDistance(path.at(1).orientation) < 1e-7);
    CHECK(std::abs(state.orientation.dot(path.at(1).orientation)) == Approx(1).epsilon(1e-14));
    // The mean velocity over the last call.
    CHECK((state.momentum - (path.at(1).position - path.at(0.95).position) / 0.05).norm() < 1e-9);
    CHECK((state.angular_momentum - Vec3(1, 2, 2)).norm() < 1e-9);
}

TEST_CASE("a floor that moves carries what stands on it, at no more cost than one at rest") {
    BulletScene scene;
    Path path;
    const bool turning = GENERATE(false, true);
    path.at = [turning](double t) -> Pose {
        const double angle = turning ? 0.5 * t : 0;
        return {Vec3(turning ? 0 : 0.3 * t, 0, -0.05), Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()))};
    };
    btRigidBody& floor = add_kinematic(scene, scene.box(Vec3(2, 2, 0.1)), path);
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0.2, 0, 0.05));
    scene.world->set_material(floor, rock(1e9, 0.8));
    scene.world->set_material(box, rock(1e9, 0.8));
    run(scene, path, 50, 2, 0.01);
    const std::size_t settling = scene.world->step_report().steps.accepted;
    run(scene, path, 50, 2, 0.01);
    CHECK(scene.world->step_report().steps.accepted - settling <= 110);
    const Vec3 ground = path.at(2).orientation.conjugate() * (position_of(box) - path.at(2).position);
    CHECK((ground - Vec3(0.2, 0, 0.1)).norm() < 2e-2);  // it slipped when the floor started
    const Vec3 speed = turning ? Vec3(Vec3(0, 0, 0.5).cross(position_of(box))) : Vec3(0.3, 0, 0);
    CHECK((to_eigen(box.getLinearVelocity()) - speed).norm() < 1e-3);
}

TEST_CASE("a plane that turns reaches everything") {
    BulletScene scene;
    Path path;
    path.at = [](double t) -> Pose {
        return {Vec3::Zero(), Quat(Eigen::AngleAxisd(0.2 * t, Vec3::UnitY()))};
    };
    add_kinematic(scene, scene.shape<btStaticPlaneShape>(btVector3(0, 0, 1), 0), path);
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(-3, 0, 0.05));
    run(scene, path, 20, 1, 0.01);
    CHECK(box.getLinearVelocity().z() == Approx(0.6).epsilon(0.02));
    CHECK(scene.world->step_report().contacts == 1);
}
