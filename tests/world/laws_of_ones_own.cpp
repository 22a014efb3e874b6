#include <catch2/catch.hpp>

#include <cmath>

#include <demos/cohesion/sintering_law.hpp>
#include <demos/hertz_mindlin/elastic_spheres_law.hpp>
#include <tests/world/steps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// The built-in law as a user's, with and without its derivative.
struct WithRates {
    static constexpr bool gives_rates = true;
    BuiltInLaw<LawParts{}> law;
    void operator()(const ContactInput& in, ContactForce& out) const { law(in, out); }
};
struct WithoutRates {
    BuiltInLaw<LawParts{}> law;
    void operator()(const ContactInput& in, ContactForce& out) const { law(in, out); }
};

struct Counting {
    struct History {
        double steps = 0;
    };
    BuiltInLaw<LawParts{}> law;
    void operator()(const ContactInput& in, std::span<const History> past, ContactForce& out,
                    History& trial) const {
        law(in, out);
        trial.steps = past.empty() ? 1 : past[0].steps + 1;
    }
};

// A cube on a slope that holds.
struct Slope {
    BulletScene scene;
    btRigidBody& floor = scene.add_floor();
    btRigidBody& cube = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.0501));
    Slope() {
        scene.world->setGravity(btVector3(3, 1, -9.81));
        for (btRigidBody* body : {&floor, &cube}) {
            scene.world->set_material(*body, rock(1e9));
            body->setGravity(scene.world->getGravity());
        }
    }
};

}  // namespace

TEST_CASE("a law of one's own does what the built-in one does, with its derivative and without") {
    Slope built_in, with, without;
    with.scene.world->set_contact_law(WithRates{});
    without.scene.world->set_contact_law(WithoutRates{});
    SteppingOptions options;
    options.tolerances.relative = 1e-6;
    for (Slope* slope : {&built_in, &with, &without}) {
        slope->scene.world->set_stepping(options);
        step(slope->scene, 30);
    }
    CHECK(position_of(with.cube) == position_of(built_in.cube));
    CHECK((position_of(without.cube) - position_of(built_in.cube)).norm() < 1e-6);
    CHECK(without.cube.getLinearVelocity().length() < 1e-8);
    const StepReport& known = with.scene.world->step_report();
    const StepReport& differenced = without.scene.world->step_report();
    CHECK(10 * differenced.steps.accepted < 13 * known.steps.accepted);
    CHECK(differenced.steps.newton.iterations < 2 * known.steps.newton.iterations);
    CHECK(std::abs(differenced.energy.residual - known.energy.residual) < 1e-3);
}

TEST_CASE("only accepted steps enter a law's own history") {
    Slope slope;
    slope.scene.world->set_contact_law(Counting{});
    step(slope.scene, 20);
    const Contact& contact = slope.scene.world->system().contacts[0];
    REQUIRE(contact.history.own.size() == highest_order);
    const double counted = contact.history.own[0];
    CHECK(counted == contact.history.own[1] + 1);
    const std::size_t before = slope.scene.world->step_report().steps.accepted;
    step(slope.scene, 10);
    const std::size_t made = slope.scene.world->step_report().steps.accepted - before;
    CHECK(contact.history.own[0] == counted + static_cast<double>(made));
}

TEST_CASE("a law of two materials is theirs alone, in either order, and what is set last counts") {
    BulletScene scene;
    btRigidBody& floor = scene.add_floor();
    const Material stone = rock(1e9);
    Material ice = rock(1e9);
    ice.density = 917;
    btRigidBody& dry = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, 0.05));
    btRigidBody& frozen = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(1, 0, 0.05));
    scene.world->set_material(floor, stone);
    scene.world->set_material(dry, stone);
    scene.world->set_material(frozen, ice);
    scene.world->set_contact_law(ice, stone, BuiltInLaw<LawParts{FrictionLaw::none, false}>{});
    const auto speeds = [&] {
        for (btRigidBody* body : {&dry, &frozen}) {
            body->setLinearVelocity(btVector3(1, 0, 0));
        }
        step(scene, 30);
        return std::pair(dry.getLinearVelocity().x(), frozen.getLinearVelocity().x());
    };
    step(scene, 5);
    auto [held, slid] = speeds();
    CHECK(std::abs(held) < 1e-3);
    CHECK(slid == Approx(1).epsilon(1e-3));
    scene.world->set_forces(stone, ice, nullptr);
    std::tie(held, slid) = speeds();
    CHECK(std::abs(slid) < 1e-3);
}

TEST_CASE("Hertz: spheres come as deep as the closed form says, and part as fast as they came") {
    BulletScene scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    ElasticSpheres law;
    law.youngs_modulus = 5e9;
    scene.world->set_contact_law(law);
    SteppingOptions options;
    options.tolerances.relative = 1e-5;
    scene.world->set_stepping(options);
    const double mass = 0.01;
    const double speed = 1;
    btRigidBody& one = scene.add(mass, scene.shape<btSphereShape>(0.01), Vec3::Zero());
    btRigidBody& other = scene.add(mass, *one.getCollisionShape(), Vec3(0, 0, 0.02001));
    one.setLinearVelocity(btVector3(0, 0, speed));
    double deepest = 0;
    for (int i = 0; i < 250; ++i) {
        step(scene, 1, 1e-6);
        if (scene.world->step_report().contacts > 0) {
            deepest = std::max(deepest, scene.world->contact_results()[0].depth);
        }
    }
    // δ = (15 m* v²/(16 E* √R*))^(2/5) (Johnson, Contact Mechanics, 11.5). Spheres that overlap by δ have a
    // patch smaller than 2π R* δ by some δ/R.
    const double depth =
        std::pow(15 * (mass / 2) * speed * speed / (16 * law.effective_modulus() * std::sqrt(0.005)), 0.4);
    CHECK(deepest == Approx(depth).epsilon(5e-3));
    CHECK(other.getLinearVelocity().z() == Approx(speed).epsilon(1e-3));
    CHECK(std::abs(one.getLinearVelocity().z()) < 1e-3);
}

TEST_CASE("a bond of the sintering law carries its strength times its patch") {
    const auto [strength, holds] = GENERATE(std::pair(1.1, true), std::pair(0.9, false));
    BulletScene scene;
    btRigidBody& ceiling =
        scene.add(0, scene.shape<btStaticPlaneShape>(btVector3(0, 0, -1), 0), Vec3::Zero());
    btRigidBody& cube = scene.add(1, scene.box(Vec3::Constant(0.1)), Vec3(0, 0, -0.05));
    scene.world->set_material(ceiling, rock(1e9));
    scene.world->set_material(cube, rock(1e9));
    SinteringLaw law;
    law.strength = strength * 9.81 / 0.01;
    scene.world->set_contact_law(law);
    cube.setGravity(btVector3(0, 0, 9.81));
    step(scene, 20);
    for (int i = 1; i <= 50; ++i) {  // slowly, so that nothing swings
        cube.setGravity(btVector3(0, 0, 9.81 * (1 - 0.04 * i)));
        step(scene, 1);
    }
    step(scene, 30);
    CHECK((position_of(cube).z() > -0.0501) == holds);
}
