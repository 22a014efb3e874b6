#include <cmath>

#include <catch2/catch.hpp>
#include <scree/contact/hertz_mindlin.hpp>

#include <tests/dynamics/residual_error.hpp>
#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double radius = 0.02;
constexpr double modulus = 1e9;

// A ball of radius 2 cm on the ground or on its like, at the given velocities, one step of 10 µs from a
// random past.
StepCase ball_case(Random& random, bool on_ground, double depth) {
    StepCase c;
    c.material = {modulus, 0.3, 0, 0, 2.0 / 7, false};
    const Vec3 up = random.direction();
    const double speed = 0.3 * depth / 1e-5;
    if (on_ground) {
        c.add_prescribed(HalfSpace{up, 0}, {});
        c.add_body(Sphere{radius}, {(radius - depth) * up, random.rotation()});
    } else {
        c.add_body(Sphere{radius}, {});
        c.add_body(Sphere{radius}, {(2 * radius - depth) * up, random.rotation()});
    }
    for (Eigen::Index i = on_ground ? 6 : 0; i < c.u.size(); ++i) {
        c.u[i] += (i % 6 < 3 ? 1 : 1 / radius) * speed * random.uniform(-1, 1);
    }
    Contact& contact = c.add_contact(0, 1);
    const double stiffness = 8 * modulus / (4 * 1.7 * 1.3) * std::sqrt(radius * depth);
    contact.history.push(
        {0.05 * modulus * std::sqrt(radius) * std::pow(depth, 1.5) * up.cross(random.vector()), up,
         stiffness * random.uniform(0.7, 1.4)});
    return c;
}

}  // namespace

TEST_CASE("A ball pressed on a wall has Hertz's force and Mindlin's stiffness", "[contact]") {
    const double depth = 1e-4;
    ContactCase c;
    c.geometry = overlap_of(placed(Sphere{radius}, {0, 0, radius - depth}), ground()).value();
    c.pair = pair_constants({modulus, 0.3, 0, 0, 2.0 / 7, false}, {2, radius}, {});
    const auto force = [&] {
        const FrictionStep step{{std::span(c.past).first(1), c.beta_h}, c.turn_a, c.turn_b};
        ContactForce out;
        HertzMindlin{0.25}({c.geometry, c.motion, c.pair, c.history, step, c.arms}, out);
        return out;
    };
    const double squeezing = modulus / (2 * (1 - 0.0625));
    const double shearing = modulus / (4 * 1.75 * 1.25);
    const double expected = 4.0 / 3 * squeezing * std::sqrt(radius) * std::pow(depth, 1.5);
    CHECK(force().normal_force == Approx(expected).epsilon(1e-12));
    c.motion.velocity = {1e-4, 0, 0};
    CHECK(force().force.x() ==
          Approx(-8 * shearing * std::sqrt(radius * depth) * 1e-4 * c.beta_h).epsilon(1e-12));
    c.motion.velocity = {1, 0, 0};
    CHECK(force().force.x() == Approx(-0.3 * expected).epsilon(1e-12));
}

TEST_CASE("The derivative of Hertz's and Mindlin's law agrees with differences of the whole step",
          "[contact]") {
    Random random(441);
    ForcesOf forces(HertzMindlin{0.3, 0.2, 0.1});
    double worst = 0;
    int slipping = 0;
    int sticking = 0;
    for (int i = 0; i < 60; ++i) {
        const StepCase c = ball_case(random, i % 2 == 0, 1e-4);
        const ResidualError found = residual_error(c, forces, 1e-5, 1, 1e-4, radius);
        if (found.state != ContactState::open) {
            slipping += found.state == ContactState::slip;
            sticking += found.state == ContactState::stick;
            worst = std::max(worst, found.error);
        }
    }
    CHECK(slipping > 5);
    CHECK(sticking > 5);
    CHECK(worst < 1e-7);
}

TEST_CASE("Damping for a restitution: none for one, more for less, and refused outside", "[contact]") {
    CHECK(hertz_damping(1) == 0);
    CHECK(hertz_damping(0.99) < hertz_damping(0.9));
    CHECK(hertz_damping(0.9) < hertz_damping(0.2));
    // With a pull allowed it would be −ln e/√(π² + ln² e), whatever the exponent (Tsuji et al.).
    const double with_pull = -std::log(0.95) / std::hypot(std::numbers::pi, std::log(0.95));
    CHECK(hertz_damping(0.95) == Approx(with_pull).epsilon(0.05));
    for (const double bad : {0.0, -1.0, 1.1}) {
        CHECK_THROWS_AS(hertz_damping(bad), std::invalid_argument);
    }
}
