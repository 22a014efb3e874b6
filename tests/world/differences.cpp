// Where the two worlds differ, each with the reason; what must agree is in both_*.cpp. The guide's table of
// methods names these tests.
#include <catch2/catch.hpp>

#include <cmath>

#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// How far a small box gets in four seconds at Bullet's default tick; μ = 0.5.
template <class World>
double tilted_slide(double angle, double azimuth) {
    SceneOf<World> scene;
    const double g = 9.81;
    scene.world->setGravity(btVector3(g * std::sin(angle) * std::cos(azimuth),
                                      g * std::sin(angle) * std::sin(azimuth), -g * std::cos(angle)));
    scene.add_floor().setFriction(1);
    btRigidBody& box = add_box(scene, Vec3(0, 0, 0.05), 0.05);
    box.setFriction(0.5);
    box.setActivationState(DISABLE_DEACTIVATION);
    run(scene, 4, 1.0 / 60);
    return std::hypot(position_of(box).x(), position_of(box).y());
}

template <class World>
double spun_energy_left() {
    SceneOf<World> scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    btRigidBody& brick =
        scene.add(1, scene.template shape<btBoxShape>(btVector3(0.1, 0.3, 0.6)), Vec3::Zero());
    brick.setActivationState(DISABLE_DEACTIVATION);
    brick.setAngularVelocity(btVector3(3, 5, 3));
    const auto energy = [&] {
        const Vec3 spin = to_eigen(brick.getWorldTransform()).orientation.conjugate() *
                          to_eigen(brick.getAngularVelocity());
        return 0.5 * to_eigen(brick.getInvInertiaDiagLocal()).cwiseInverse().dot(spin.cwiseAbs2());
    };
    const double before = energy();
    run(scene, 10);
    return energy() / before;
}

// Well below what is checked.
SteppingOptions tight() {
    SteppingOptions options;
    options.tolerances.relative = 1e-5;
    return options;
}

}  // namespace

TEST_CASE("differs: friction holds below atan μ and lets go above in every direction") {
    // Bullet's solver lets this box go far below, along an axis and beside it, and holds it at 45 degrees.
    const double azimuth = GENERATE(0.0, 0.5, M_PI / 4);
    const double below = std::atan(0.4);
    CHECK(tilted_slide<DynamicsWorld>(below, azimuth) < 1e-4);
    CHECK(tilted_slide<DynamicsWorld>(std::atan(0.51), azimuth) > 0.5);
    CHECK((tilted_slide<btDiscreteDynamicsWorld>(below, azimuth) > 0.5) == (azimuth <= 0.5));
}

TEST_CASE("differs: a tumbling body keeps its energy") {
    // Bullet's gyroscopic term is implicit Euler, which damps; here L is a state of its own. Flags that
    // choose Bullet's treatment have no effect.
    CHECK(spun_energy_left<btDiscreteDynamicsWorld>() < 0.97);
    CHECK(spun_energy_left<DynamicsWorld>() == Approx(1).epsilon(0.01));
}

TEST_CASE("differs: nothing tunnels, whatever the flags for continuous collision say") {
    // Steps end where a contact begins; Bullet needs a threshold and a swept sphere for each body.
    const auto passed = [](auto scene, bool continuous) {
        scene->world->setGravity(btVector3(0, 0, 0));
        scene->add(0, scene->template shape<btBoxShape>(btVector3(5, 5, 0.01)), Vec3::Zero());
        btRigidBody& bullet = scene->add(0.1, scene->template shape<btSphereShape>(0.05), Vec3(0, 0, 2));
        bullet.setLinearVelocity(btVector3(0, 0, -200));
        if (continuous) {
            bullet.setCcdMotionThreshold(0.01);
            bullet.setCcdSweptSphereRadius(0.04);
        }
        for (int i = 0; i < 10; ++i) {
            scene->world->stepSimulation(1.0 / 60, 1, 1.0 / 60);
        }
        return position_of(bullet).z() < -0.1;
    };
    CHECK(passed(std::make_unique<StockScene>(), false));
    CHECK_FALSE(passed(std::make_unique<StockScene>(), true));
    CHECK_FALSE(passed(std::make_unique<BulletScene>(), false));
    CHECK_FALSE(passed(std::make_unique<BulletScene>(), true));
}

TEST_CASE("differs: none falls asleep of itself unless the option is on") {
    // Bullet stops what has been slower than its thresholds for two seconds, at rest or not; here rest is
    // confirmed by the balance of forces, and asked for.
    const auto state = [](auto scene) {
        scene->add(0, scene->template shape<btBoxShape>(btVector3(5, 5, 0.5)), Vec3(0, 0, -0.5));
        btRigidBody& box =
            scene->add(1, scene->template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, 0, 0.5));
        run(*scene, 3);
        return box.getActivationState();
    };
    CHECK(state(std::make_unique<StockScene>()) == ISLAND_SLEEPING);
    CHECK(state(std::make_unique<BulletScene>()) == ACTIVE_TAG);
}

TEST_CASE("differs: a sleeper that is pushed or loses its support wakes up") {
    // Bullet forgets a velocity given to a sleeping body, and leaves it hanging when its support is removed.
    const auto moves = [](auto scene, bool pushed) {
        btRigidBody& box =
            scene->add(1, scene->template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, 0, 0.5));
        btRigidBody& ground =
            scene->add(0, scene->template shape<btBoxShape>(btVector3(5, 5, 0.5)), Vec3(0, 0, -0.5));
        run(*scene, 0.5);
        box.forceActivationState(ISLAND_SLEEPING);
        run(*scene, 0.1);
        const Vec3 before = position_of(box);
        if (pushed) {
            box.setLinearVelocity(btVector3(1, 0, 1));
        } else {
            scene->world->removeRigidBody(&ground);
        }
        run(*scene, 0.1);
        const bool moved = (position_of(box) - before).norm() > 0.01;
        if (!pushed) {
            scene->world->addRigidBody(&ground);
        }
        return moved;
    };
    const bool pushed = GENERATE(true, false);
    CHECK_FALSE(moves(std::make_unique<StockScene>(), pushed));
    CHECK(moves(std::make_unique<BulletScene>(), pushed));
}

TEST_CASE("differs: bodies sink in by what their stiffness and load say") {
    // Bullet solves for no penetration but for what its iterations leave; here it is F Lc/(Y A), and Y of a
    // body without material is such that it sinks in by 10⁻⁴ of its size under its own weight, not others'.
    const double load = 101 * 9.81;
    const auto sunk = [](auto& scene) {
        scene.add(0, scene.template shape<btBoxShape>(btVector3(5, 5, 0.5)), Vec3(0, 0, -0.5));
        btRigidBody& light =
            scene.add(1, scene.template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, 0, 0.5));
        scene.add(100, *light.getCollisionShape(), Vec3(0, 0, 1.5));
        run(scene, 2);
        return 0.5 - position_of(light).z();
    };
    StockScene stock;
    CHECK(sunk(stock) < 1e-3);
    BulletScene scene;
    scene.world->set_stepping(tight());
    const double depth = sunk(scene);
    const Contact& contact = scene.world->system().contacts[0];
    CHECK(contact.pair.elastic > 0);
    CHECK(depth == Approx(load / contact.pair.elastic).epsilon(1e-3));
}

TEST_CASE("differs: bodies bounce as their restitution says, boxes and balls, at any step") {
    // Bullet's box overshoots by its several points, and its ball does not bounce at all: the speculative
    // contact takes its speed.
    const auto bounced = [](auto& scene, bool ball) {
        scene.add(0, scene.template shape<btBoxShape>(btVector3(5, 5, 0.5)), Vec3(0, 0, -0.5))
            .setRestitution(1);
        btRigidBody& body =
            ball ? scene.add(1, scene.template shape<btSphereShape>(0.5), Vec3(0, 0, 1))
                 : scene.add(1, scene.template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, 0, 1));
        body.setRestitution(0.5);
        double highest = 0;
        for (int i = 0; i < 120; ++i) {
            run(scene, 1.0 / 240);
            highest = std::max(highest, body.getLinearVelocity().z());
        }
        return highest / std::sqrt(9.81);
    };
    const bool ball = GENERATE(true, false);
    StockScene stock;
    CHECK(std::abs(bounced(stock, ball) - 0.5) > 0.1);
    BulletScene scene;
    scene.world->set_stepping(tight());
    // The weight acts during the contact's ten milliseconds, which takes some 3 % of the box's speed.
    // A ball's patch grows with its depth, so that its force is no linear spring's.
    CHECK(bounced(scene, ball) == Approx(0.5).epsilon(ball ? 0.1 : 0.05));
}

TEST_CASE("differs: joints are refused") {
    // The contact solver of joints is Bullet's own, which is not used here.
    BulletScene scene;
    btRigidBody& box = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3::Zero());
    btPoint2PointConstraint joint(box, btVector3(0, 0, 0));
    CHECK_THROWS_WITH(scene.world->addConstraint(&joint), Catch::Contains("joints"));
}

TEST_CASE("refused: solving constraints by hand") {
    // Contacts are forces, stepped together with the bodies: there is nothing to be solved between.
    BulletScene scene;
    CHECK_THROWS_WITH(scene.world->solveConstraints(scene.world->getSolverInfo()), Catch::Contains("solver"));
}

TEST_CASE("differs: islands are the method's own groups") {
    // The method's groups are those that may touch before the next meeting; Bullet's island tags are not set.
    const auto tagged = [](auto scene) {
        btRigidBody& box = scene->add(1, scene->template shape<btSphereShape>(0.5), Vec3::Zero());
        run(*scene, 0.1);
        return box.getIslandTag() >= 0 && scene->world->getSimulationIslandManager() != nullptr;
    };
    CHECK(tagged(std::make_unique<StockScene>()));
    CHECK_FALSE(tagged(std::make_unique<BulletScene>()));
}

TEST_CASE("differs: a solver and its settings have no effect") {
    // Error is controlled by tolerances, see set_stepping().
    const auto height = [](bool settings) {
        BulletScene scene;
        scene.add(0, scene.shape<btBoxShape>(btVector3(5, 5, 0.5)), Vec3(0, 0, -0.5));
        btRigidBody& box = scene.add(1, scene.shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, 0, 0.6));
        btSequentialImpulseConstraintSolver solver;
        if (settings) {
            scene.world->setConstraintSolver(&solver);
            CHECK(scene.world->getConstraintSolver() == &solver);
            scene.world->getSolverInfo().m_numIterations = 1;
            scene.world->getSolverInfo().m_globalCfm = 1;
            scene.world->setApplySpeculativeContactRestitution(true);
            CHECK(scene.world->getApplySpeculativeContactRestitution());
        }
        run(scene, 0.3);
        return position_of(box).z();
    };
    CHECK(height(true) == height(false));
}

TEST_CASE("differs: what a callback writes into a contact's point has no effect") {
    // Points are made from the contacts, after the forces; friction and restitution are the bodies' or their
    // materials', and set_mixing() and set_contact_law() are there for others.
    const auto slid = [](auto scene) {
        gContactAddedCallback = [](btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                                   const btCollisionObjectWrapper*, int, int) {
            point.m_combinedFriction = 0;
            return true;
        };
        scene->add(0, scene->template shape<btBoxShape>(btVector3(5, 5, 0.5)), Vec3(0, 0, -0.5));
        btRigidBody& box =
            scene->add(1, scene->template shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), Vec3(0, 0, 0.5));
        box.setCollisionFlags(btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
        run(*scene, 0.1);
        box.setLinearVelocity(btVector3(1, 0, 0));
        run(*scene, 0.5);
        gContactAddedCallback = nullptr;
        return box.getLinearVelocity().x() > 0.9;
    };
    CHECK(slid(std::make_unique<StockScene>()));
    CHECK_FALSE(slid(std::make_unique<BulletScene>()));
}
