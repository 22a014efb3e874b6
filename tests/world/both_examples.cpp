// Small programs as they come with physics engines, each run on both worlds.
#include <catch2/catch.hpp>

#include <cmath>

#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double tick = 1.0 / 120;

}  // namespace

TEMPLATE_TEST_CASE("both worlds, basic boxes: a block of boxes falls and stands", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    add_ground(scene);
    auto& box = scene.template shape<btBoxShape>(btVector3(0.1, 0.1, 0.1));
    std::vector<btRigidBody*> boxes;
    for (int i = 0; i < 27; ++i) {
        boxes.push_back(&scene.add(1, box, Vec3(0.25 * (i % 3), 0.25 * (i / 3 % 3), 0.15 + 0.21 * (i / 9))));
    }
    run(scene, 1.5, tick);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        CHECK(position_of(*boxes[i]).z() == Approx(0.1 + 0.2 * static_cast<double>(i / 9)).margin(5e-3));
        CHECK(boxes[i]->getLinearVelocity().length() < 0.02);
    }
}

TEMPLATE_TEST_CASE("both worlds, compounds: tables fall on their feet and dumbbells on their sides", "[both]",
                   BOTH_WORLDS) {
    SceneOf<TestType> scene;
    add_ground(scene);
    auto& leg = scene.template shape<btBoxShape>(btVector3(0.05, 0.05, 0.2));
    auto& top = scene.template shape<btBoxShape>(btVector3(0.4, 0.4, 0.05));
    btCompoundShape whole;
    const auto at = [](double x, double y, double z) {
        return btTransform(btQuaternion::getIdentity(), btVector3(x, y, z));
    };
    whole.addChildShape(at(0, 0, 0.25), &top);
    for (int i = 0; i < 4; ++i) {
        whole.addChildShape(at(i % 2 == 0 ? 0.3 : -0.3, i / 2 == 0 ? 0.3 : -0.3, 0), &leg);
    }
    // Bullet's own way to the mass centre and principal axes.
    const btScalar masses[] = {2, 0.5, 0.5, 0.5, 0.5};
    btTransform principal;
    btVector3 inertia;
    whole.calculatePrincipalAxisTransform(masses, principal, inertia);
    btCompoundShape& table = scene.template shape<btCompoundShape>();
    for (int i = 0; i < whole.getNumChildShapes(); ++i) {
        table.addChildShape(principal.inverse() * whole.getChildTransform(i), whole.getChildShape(i));
    }
    CHECK(principal.getOrigin().z() == Approx(0.125));
    btRigidBody& body = scene.make(4, table, Vec3::Zero());
    body.setMassProps(4, inertia);
    body.setWorldTransform(at(0, 0, 0.4) * principal);
    scene.world->addRigidBody(&body);
    run(scene, 1.5, tick);
    const btVector3 up =
        body.getWorldTransform().getBasis() * (principal.getBasis().inverse() * btVector3(0, 0, 1));
    CHECK(up.z() == Approx(1).epsilon(1e-3));
    CHECK(position_of(body).z() == Approx(0.2 + 0.125).margin(5e-3));
}

TEMPLATE_TEST_CASE("both worlds, kinematic: a lift carries its load up and down", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    btDefaultMotionState path(btTransform::getIdentity());
    btRigidBody& lift = scene.make(0, scene.template shape<btBoxShape>(btVector3(1, 1, 0.1)), Vec3::Zero());
    lift.setMotionState(&path);
    lift.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    lift.setActivationState(DISABLE_DEACTIVATION);
    scene.world->addRigidBody(&lift);
    btRigidBody& load =
        scene.add(1, scene.template shape<btBoxShape>(btVector3(0.2, 0.2, 0.2)), Vec3(0, 0, 0.3));
    load.setActivationState(DISABLE_DEACTIVATION);
    double worst = 0;
    for (int i = 1; i <= 240; ++i) {
        const double height = 0.3 * (1 - std::cos(M_PI * i * tick));
        path.setWorldTransform(to_bullet(Pose{Vec3(0, 0, height), Quat::Identity()}));
        run(scene, tick, tick);
        worst = std::max(worst, std::abs(position_of(load).z() - 0.3 - height));
    }
    CHECK(worst < 0.02);
    CHECK(position_of(load).head<2>().norm() < 1e-3);
}

TEMPLATE_TEST_CASE("both worlds, filtering: three kinds, of which two meet", "[both]", BOTH_WORLDS) {
    constexpr int ground = 1, red = 2, blue = 4;
    SceneOf<TestType> scene;
    auto& box = scene.template shape<btBoxShape>(btVector3(0.2, 0.2, 0.2));
    btRigidBody& plate =
        scene.make(0, scene.template shape<btBoxShape>(btVector3(5, 5, 0.5)), Vec3(0, 0, -0.5));
    scene.world->addRigidBody(&plate, ground, red | blue);
    btRigidBody& first = scene.make(1, box, Vec3(0, 0, 0.25));
    btRigidBody& through = scene.make(1, box, Vec3(0, 0, 0.7));
    btRigidBody& upon = scene.make(1, box, Vec3(2, 0, 0.7));
    btRigidBody& below = scene.make(1, box, Vec3(2, 0, 0.25));
    scene.world->addRigidBody(&first, red, ground | red);
    scene.world->addRigidBody(&through, blue, ground | blue);
    scene.world->addRigidBody(&upon, red, ground | red);
    scene.world->addRigidBody(&below, red, ground | red);
    run(scene, 1.2, tick);
    CHECK(position_of(first).z() == Approx(0.2).margin(5e-3));
    CHECK(position_of(through).z() == Approx(0.2).margin(5e-3));
    CHECK(position_of(below).z() == Approx(0.2).margin(5e-3));
    CHECK(position_of(upon).z() == Approx(0.6).margin(1e-2));
}

TEMPLATE_TEST_CASE("both worlds, rays: a fan of rays sees the field of boxes", "[both]", BOTH_WORLDS) {
    SceneOf<TestType> scene;
    add_ground(scene);
    auto& box = scene.template shape<btBoxShape>(btVector3(0.2, 0.2, 0.2));
    for (int i = 0; i < 9; ++i) {
        scene.add(1, box, Vec3(i % 3 - 1, i / 3 - 1, 0.2));
    }
    run(scene, 0.2, tick);
    int boxes = 0, plates = 0, sky = 0;
    for (int i = -20; i <= 20; ++i) {
        for (int j = -20; j <= 20; ++j) {
            const btVector3 from(0.1 * i, 0.1 * j, 5);
            const btVector3 to = from - btVector3(0, 0, i == 20 ? 1 : 10);
            btCollisionWorld::ClosestRayResultCallback ray(from, to);
            scene.world->rayTest(from, to, ray);
            sky += !ray.hasHit();
            boxes += ray.hasHit() && !ray.m_collisionObject->isStaticObject();
            plates += ray.hasHit() && ray.m_collisionObject->isStaticObject();
        }
    }
    CHECK(sky == 41);
    // Rays along an edge may see either, so that each box has 3 × 3 to 5 × 5 of them.
    CHECK(boxes >= 9 * 9);
    CHECK(boxes <= 9 * 25);
    CHECK(boxes + plates + sky == 41 * 41);
}

TEMPLATE_TEST_CASE("both worlds, gyroscopic: a handle that spins about its middle axis turns over", "[both]",
                   BOTH_WORLDS) {
    SceneOf<TestType> scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btCompoundShape& handle = scene.template shape<btCompoundShape>();
    handle.addChildShape(to_bullet(Pose{Vec3(0, -0.1, 0), Quat::Identity()}),
                         &scene.template shape<btBoxShape>(btVector3(0.3, 0.05, 0.05)));
    handle.addChildShape(to_bullet(Pose{Vec3(0, 0.1, 0), Quat::Identity()}),
                         &scene.template shape<btBoxShape>(btVector3(0.05, 0.15, 0.05)));
    btRigidBody& body = scene.make(1, handle, Vec3::Zero());
    body.setMassProps(1, btVector3(0.01, 0.02, 0.028));
    body.setFlags(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
    body.setActivationState(DISABLE_DEACTIVATION);
    scene.world->addRigidBody(&body);
    body.setAngularVelocity(btVector3(0.05, 8, 0));
    double lowest = 1;
    for (int i = 0; i < 300; ++i) {
        run(scene, tick, tick);
        lowest = std::min(lowest, body.getWorldTransform().getBasis().getColumn(1).y());
    }
    CHECK(lowest < -0.8);
}
