// Single impacts of balls by Hertz's and Mindlin's law, of the materials and speeds of Y. C. Chung and J. Y.
// Ooi, Benchmark tests for verifying discrete element modelling codes at particle impact level, Granular
// Matter 13 (2011) 643–656, against closed forms.

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <scree/contact/hertz_mindlin.hpp>

#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double pi = std::numbers::pi;

struct Ball {
    const char* material;
    double modulus, poisson_ratio, density;  // [Pa], -, [kg/m³]
    double radius, speed;                    // [m], [m/s]

    [[nodiscard]] double mass() const { return 4.0 / 3 * pi * std::pow(radius, 3) * density; }
    [[nodiscard]] double plane_strain_modulus() const {
        return modulus / (1 - poisson_ratio * poisson_ratio);
    }
};

/// The largest depth and the duration of an elastic impact.
struct HertzImpact {
    double depth, force, duration;

    HertzImpact(double modulus, double radius, double mass, double speed)
        : depth(std::pow(15 * mass * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4)),
          force(4.0 / 3 * modulus * std::sqrt(radius) * std::pow(depth, 1.5)),
          // 2 ∫ dx/√(1 − x^(5/2)) from 0 to 1
          duration(2 * std::sqrt(pi) * std::tgamma(1.4) / std::tgamma(0.9) * depth / speed) {}
};

struct Impact {
    double force = 0, depth = 0, duration = 0;  // the largest of the first two
    Vec3 velocity, spin;                        // after it, of the first ball
};

class Shot {
  public:
    Shot(const Ball& ball, const HertzMindlin& law, double friction, const Method method = Method::bdf)
        : ball_(ball) {
        material_ = {ball.density, ball.modulus, friction};
        material_.torsion = false;
        scene_.world->setGravity(btVector3(0, 0, 0));
        SteppingOptions options;
        options.method = method;
        options.tolerances = {1e-7, 1e-10, 0};
        const double slowest =
            HertzImpact(ball.plane_strain_modulus(), ball.radius, ball.mass(), ball.speed).duration;
        if (method != Method::bdf) {
            options.fixed_step = slowest / 2000;
        }
        scene_.world->set_stepping(options);
        scene_.world->set_contact_law(law);
        first_ = &add_ball({0, 0, ball.radius});
        tick_ = slowest / 40;
    }

    /// On a wall that is a thousand times as stiff.
    Impact on_wall(double angle, double speed) {
        btRigidBody& wall = scene_.add_floor();
        Material hard = material_;
        hard.youngs_modulus *= 1000;
        scene_.world->set_material(wall, hard);
        first_->setLinearVelocity(to_bullet(Vec3(speed * std::sin(angle), 0, -speed * std::cos(angle))));
        return follow();
    }
    /// On a second ball, each with the ball's speed.
    Impact on_its_like() {
        btRigidBody& second = add_ball({0, 0, -ball_.radius});
        first_->setLinearVelocity(to_bullet(Vec3(0, 0, -ball_.speed)));
        second.setLinearVelocity(to_bullet(Vec3(0, 0, ball_.speed)));
        return follow();
    }

  private:
    btRigidBody& add_ball(const Vec3& position) {
        btRigidBody& body = scene_.add(ball_.mass(), scene_.shape<btSphereShape>(ball_.radius), position);
        scene_.world->set_material(body, material_);
        return body;
    }

    Impact follow() {
        Impact impact;
        bool touched = false;
        for (int i = 0; i < 4000; ++i) {
            scene_.world->stepSimulation(tick_, 0);
            INFO(scene_.world->step_report().message);
            REQUIRE_FALSE(scene_.world->step_report().failed);
            const auto results = scene_.world->contact_results();
            const bool touching = !results.empty() && results[0].law.state != ContactState::open;
            if (touching) {
                touched = true;
                impact.force = std::max(impact.force, results[0].law.normal_force);
                impact.depth = std::max(impact.depth, results[0].depth);
                impact.duration += tick_;
            } else if (touched) {
                break;
            }
        }
        impact.velocity = to_eigen(first_->getLinearVelocity());
        impact.spin = to_eigen(first_->getAngularVelocity());
        return impact;
    }

    BulletScene scene_;
    Ball ball_;
    Material material_;
    btRigidBody* first_;
    double tick_;
};

}  // namespace

TEST_CASE("Tests 1 and 2: elastic impacts have Hertz's depth, force and duration", "[laws]") {
    for (const Ball& ball :
         {Ball{"glass", 4.8e10, 0.2, 2800, 0.01, 10}, Ball{"limestone", 2e10, 0.25, 2500, 0.01, 10}}) {
        CAPTURE(ball.material);
        const Impact impact = Shot(ball, {ball.poisson_ratio}, 0.35).on_its_like();
        const HertzImpact expected(ball.plane_strain_modulus() / 2, ball.radius / 2, ball.mass() / 2,
                                   2 * ball.speed);
        CHECK(impact.depth == Approx(expected.depth).epsilon(5e-3));
        CHECK(impact.force == Approx(expected.force).epsilon(1e-2));
        CHECK(impact.duration == Approx(expected.duration).epsilon(0.05));
        CHECK(impact.velocity.z() == Approx(ball.speed).epsilon(1e-3));
    }
    for (const Ball& ball : {Ball{"aluminium alloy", 7e10, 0.3, 2699, 0.1, 0.2},
                             Ball{"magnesium alloy", 4e10, 0.35, 1800, 0.1, 0.2}}) {
        CAPTURE(ball.material);
        const Impact impact = Shot(ball, {ball.poisson_ratio}, 0).on_wall(0, ball.speed);
        const HertzImpact expected(ball.plane_strain_modulus() / 1.001, ball.radius, ball.mass(), ball.speed);
        CHECK(impact.depth == Approx(expected.depth).epsilon(5e-3));
        CHECK(impact.force == Approx(expected.force).epsilon(5e-3));
        CHECK(impact.duration == Approx(expected.duration).epsilon(0.05));
    }
}

TEST_CASE("Test 3: the restitution is the prescribed one, whatever the material and the speed", "[laws]") {
    for (const Ball& ball : {Ball{"aluminium oxide", 3.8e11, 0.23, 4000, 0.0025, 3.9},
                             Ball{"cast iron", 1e11, 0.25, 7000, 0.0025, 3.9}}) {
        for (const double restitution : {0.2, 0.4, 0.6, 0.8, 1.0}) {
            CAPTURE(ball.material, restitution);
            const HertzMindlin law{ball.poisson_ratio, hertz_damping(restitution)};
            CHECK(Shot(ball, law, 0).on_wall(0, ball.speed).velocity.z() ==
                  Approx(restitution * ball.speed).epsilon(2e-3));
        }
    }
}

TEST_CASE("Test 4: where the contact slides all the time, speed and spin after it are Coulomb's", "[laws]") {
    constexpr double friction = 0.092;
    constexpr double restitution = 0.98;
    for (const Ball& ball : {Ball{"aluminium oxide", 3.8e11, 0.23, 4000, 0.0025, 3.9},
                             Ball{"aluminium alloy", 7e10, 0.33, 2700, 0.0025, 3.9}}) {
        for (const double degrees : {35.0, 45.0, 60.0, 80.0}) {
            CAPTURE(ball.material, degrees);
            const double angle = degrees * pi / 180;
            const double beta = hertz_damping(restitution);
            const Impact impact =
                Shot(ball, {ball.poisson_ratio, beta, beta}, friction).on_wall(angle, ball.speed);
            const double impulse =
                friction * (1 + restitution) * ball.speed * std::cos(angle);  // over the mass
            CHECK(impact.velocity.x() == Approx(ball.speed * std::sin(angle) - impulse).epsilon(2e-3));
            CHECK(std::abs(impact.spin.y()) == Approx(2.5 * impulse / ball.radius).epsilon(1e-2));
        }
    }
}

TEST_CASE("Test 4: the spring turns the patch back at middling angles, and past that at steep ones",
          "[laws]") {
    // Maw, Barber and Fawcett (1976): in sticking contact the tangential spring swings 1.7 times while the
    // normal one does half a period, as (7/2) kt/kn = 7 (1−ν)/(2−ν) has it.
    const Ball ball{"aluminium oxide", 3.8e11, 0.23, 4000, 0.0025, 3.9};
    const double beta = hertz_damping(0.98);
    const auto patch_after = [&](double degrees) {
        const double angle = degrees * pi / 180;
        const Impact impact = Shot(ball, {ball.poisson_ratio, beta, beta}, 0.092).on_wall(angle, ball.speed);
        // About the point of contact nothing turns the ball.
        const double kept = impact.velocity.x() + 0.4 * ball.radius * impact.spin.y();
        CHECK(kept == Approx(ball.speed * std::sin(angle)).epsilon(1e-3));
        return (impact.velocity.x() - ball.radius * impact.spin.y()) / (ball.speed * std::sin(angle));
    };
    CHECK(patch_after(2) > 0.2);
    CHECK(patch_after(20) < -0.05);
}

TEST_CASE("Hertz and Mindlin's law steps explicitly with the same outcome", "[laws]") {
    const Ball ball{"aluminium alloy", 7e10, 0.33, 2700, 0.0025, 3.9};
    const double beta = hertz_damping(0.98);
    const HertzMindlin law{ball.poisson_ratio, beta, beta};
    const double angle = 20 * pi / 180;
    const Impact implicit = Shot(ball, law, 0.092).on_wall(angle, ball.speed);
    for (const Method method : {Method::velocity_verlet, Method::symplectic_euler}) {
        const Impact stepped = Shot(ball, law, 0.092, method).on_wall(angle, ball.speed);
        CHECK(stepped.velocity.x() == Approx(implicit.velocity.x()).epsilon(5e-3));
        CHECK(stepped.velocity.z() == Approx(implicit.velocity.z()).epsilon(5e-3));
        CHECK(stepped.spin.y() == Approx(implicit.spin.y()).epsilon(2e-2));
    }
}
