#include <catch2/catch.hpp>

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <scree/world/automatic_material.hpp>
#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// A cube on the floor after one tick; the constants of the pair.
struct CubeOnFloor {
    BulletScene scene;
    btRigidBody& floor = scene.add_floor();
    btRigidBody& cube = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.05));

    PairConstants pair() {
        scene.world->stepSimulation(1e-3, 1, 1e-3);
        INFO(scene.world->step_report().message);
        REQUIRE(scene.world->system().contacts.size() == 1);
        return scene.world->system().contacts[0].pair;
    }
    double length() const { return 2 * sphere_radius(1e-3); }
};

btScalar sum_of_frictions(const btCollisionObject* a, const btCollisionObject* b) {
    return a->getFriction() + b->getFriction();
}

}  // namespace

TEST_CASE("given materials are mixed by the rules") {
    CubeOnFloor on;
    on.scene.world->set_material(on.cube, rock(1e9, 0.4));
    on.scene.world->set_material(on.floor, rock(3e9, 0.6));
    const PairConstants pair = on.pair();
    CHECK(pair.elastic == Approx(1.5e9 / on.length()));
    CHECK(pair.friction == 0.4);
    CHECK(pair.length == Approx(on.length()));
    CHECK(pair.reduced_mass == Approx(1));
}

TEST_CASE("a change of material or friction reaches pairs that are there") {
    CubeOnFloor on;
    on.scene.world->set_material(on.cube, rock(1e9, 0.4));
    CHECK(on.pair().elastic == Approx(1e9 / on.length()));  // the floor is as stiff as the cube
    on.scene.world->set_material(on.cube, rock(2e9, 0.3));
    CHECK(on.pair().elastic == Approx(2e9 / on.length()));
    CHECK(on.pair().friction == 0.3);
    on.floor.setFriction(0.1);
    CHECK(on.pair().friction == 0.1);
}

TEST_CASE("bodies without materials take Bullet's own combinations") {
    CubeOnFloor on;
    on.cube.setFriction(0.5);
    on.floor.setFriction(0.8);
    on.cube.setRestitution(0.9);
    on.floor.setRestitution(0.9);
    CHECK(on.pair().friction == Approx(0.4));
    const double stiffness = on.pair().elastic;
    const double damping = 2 * damping_ratio(0.81) * std::sqrt(stiffness * 1) / on.length();
    CHECK(on.pair().normal_damping == Approx(damping));

    const CalculateCombinedCallback kept = gCalculateCombinedFrictionCallback;
    gCalculateCombinedFrictionCallback = sum_of_frictions;
    on.cube.setFriction(0.25);
    const double friction = on.pair().friction;
    gCalculateCombinedFrictionCallback = kept;
    CHECK(friction == Approx(1.05));
}

TEST_CASE("a mixing of one's own gets the bodies in their order") {
    CubeOnFloor on;
    on.scene.world->set_material(on.cube, rock(1e9, 0.4));
    on.scene.world->set_material(on.floor, rock(3e9, 0.6));
    on.scene.world->set_mixing(
        [&](const btRigidBody& a, const Material& of_a, const btRigidBody& b, const Material& of_b) {
            CHECK(&a == &on.floor);
            CHECK(&b == &on.cube);
            CHECK(of_a.friction == 0.6);
            PairMaterial pair = mix(of_a, of_b);
            pair.friction = 0.123;
            return pair;
        });
    CHECK(on.pair().friction == 0.123);
}

TEST_CASE("the parts of the law that no pair needs change nothing by being left out") {
    const auto run = [](bool whole_law) {
        BulletScene scene;
        btRigidBody& floor = scene.add_floor();
        Material smooth = rock(1e8, 0);
        smooth.torsion = false;
        btRigidBody& cube = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.06),
                                      Quat(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized())));
        scene.world->set_material(floor, smooth);
        scene.world->set_material(cube, smooth);
        if (whole_law) {
            scene.world->set_contact_law(BuiltInLaw<LawParts{}>{});
        }
        for (int i = 0; i < 30; ++i) {
            scene.world->stepSimulation(0.01, 1, 0.01);
        }
        return position_of(cube);
    };
    CHECK(run(true) == run(false));
}

TEST_CASE("a choice of the built-in law holds from the next tick on, and a law of one's own replaces it") {
    // A cube that is pulled below μ: viscous friction lets it creep, Cundall and Strack's does not.
    BulletScene scene;
    btRigidBody& floor = scene.add_floor();
    btRigidBody& cube = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.05));
    scene.world->set_material(floor, rock(1e8, 0.5));
    scene.world->set_material(cube, rock(1e8, 0.5));
    scene.world->setGravity(btVector3(0.3 * 9.81, 0, -9.81));
    const auto speed_after_a_while = [&] {
        for (int i = 0; i < 30; ++i) {
            scene.world->stepSimulation(0.02, 1, 0.02);
        }
        INFO(scene.world->step_report().message);
        REQUIRE_FALSE(scene.world->step_report().failed);
        return cube.getLinearVelocity().x();
    };
    CHECK(std::abs(speed_after_a_while()) < 1e-9);
    scene.world->set_contact_law(FrictionLaw::viscous);
    const double creep = speed_after_a_while();
    const PairConstants& pair = scene.world->system().contacts[0].pair;
    CHECK(creep == Approx(0.3 * 9.81 / pair.tangential_damping).epsilon(1e-4));
    scene.world->set_contact_law(FrictionLaw::viscous, {.reduced_mass = ReducedMass::round});
    const double factor = std::sqrt(pair.reduced_mass / pair.round_mass);
    CHECK(speed_after_a_while() == Approx(factor * creep).epsilon(1e-3));
    scene.world->set_contact_law(BuiltInLaw<LawParts{}>{});
    CHECK(std::abs(speed_after_a_while()) < 1e-9);
}

TEST_CASE("Bullet's contact stiffness, damping and rolling friction are taken over, and can be asked for") {
    CubeOnFloor on;
    on.cube.setContactStiffnessAndDamping(2e5, 30);
    on.cube.setRollingFriction(0.01);
    on.floor.setFriction(1);
    on.floor.setRollingFriction(0.02);
    on.cube.setFriction(0.5);
    const Material own = on.scene.world->material(on.cube);
    CHECK(own.youngs_modulus == Approx(2e5 / on.length()));
    CHECK(own.normal_damping == Approx(30 / std::sqrt(2e5)));
    CHECK(own.rolling_friction == Approx(0.01 / (0.5 * on.length())));
    // Bullet adds the dampings, of which each body has 0.1 unless told otherwise, puts the stiffnesses in a
    // row, and weighs each rolling friction with the other's friction.
    const PairMaterial pair = on.scene.world->pair_material(on.floor, on.cube);
    CHECK(pair.youngs_modulus == Approx(2e5 / on.length()));
    CHECK(pair.normal_damping == Approx(30.1 / std::sqrt(2e5)));
    CHECK(pair.rolling_friction == Approx((0.01 + 0.01) / (0.5 * on.length())));
    CHECK(pair.friction == Approx(0.5));
    CHECK(pair.even_damping);
    const PairConstants constants = on.pair();
    CHECK(constants.elastic == Approx(pair.youngs_modulus / on.length()));
    on.scene.world->set_material(on.cube, rock(1e9, 0.4));
    CHECK(on.scene.world->pair_material(on.floor, on.cube).youngs_modulus == 1e9);
    CHECK_FALSE(on.pair().even_damping);
}

TEST_CASE("a ball with Bullet's rolling friction comes to rest, one without rolls on") {
    const auto speed = [](double rolling) {
        BulletScene scene;
        btRigidBody& floor = scene.add_floor();
        btRigidBody& ball = scene.add(1, scene.shape<btSphereShape>(0.1), Vec3(0, 0, 0.1));
        floor.setFriction(1);
        ball.setFriction(0.5);
        ball.setRollingFriction(rolling);
        for (int i = 0; i < 100; ++i) {
            if (i == 10) {
                ball.setLinearVelocity(btVector3(0.5, 0, 0));
                ball.setAngularVelocity(btVector3(0, 5, 0));
            }
            scene.world->stepSimulation(0.01, 1, 0.01);
        }
        INFO(scene.world->step_report().message);
        REQUIRE_FALSE(scene.world->step_report().failed);
        return ball.getLinearVelocity().length();
    };
    CHECK(speed(0) == Approx(0.5).epsilon(1e-2));
    CHECK(speed(0.02) < 1e-3);
}
