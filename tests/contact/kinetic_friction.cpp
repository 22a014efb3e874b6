#include <cmath>

#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-13;
constexpr double held = 0.5;
constexpr double kinetic = 0.3;

ContactCase with_kinetic_friction() {
    ContactCase c;
    PairMaterial material{1e7, held, 0.5, 0, 2.0 / 7, true};
    material.kinetic_friction = kinetic;
    c.pair = pair_constants(material, {2, 0.06}, {});
    return c;
}

// The spring's force over fn, after a relative move along x [m] in the present step.
double after_move(ContactCase& c, double move) {
    c.motion.velocity = {move / c.beta_h, 0, 0};
    const ContactForce out = c.force();
    c.history.push(out.trial);
    return out.trial.force.x() / c.normal_force();
}

}  // namespace

TEST_CASE(
    "A spring holds up to the static limit, falls to the kinetic one, and holds anew when it falls short",
    "[contact]") {
    ContactCase c = with_kinetic_friction();
    const double unit = c.normal_force() / c.pair.tangential_stiffness;  // [m], the move that makes fn
    CHECK(after_move(c, -0.499 * unit) == Approx(0.499).epsilon(rounding));
    CHECK_FALSE(c.history.past[0].slipping);
    CHECK(after_move(c, -0.002 * unit) == Approx(kinetic).epsilon(rounding));
    CHECK(c.history.past[0].slipping);
    CHECK(after_move(c, -0.1 * unit) == Approx(kinetic).epsilon(rounding));
    CHECK(after_move(c, 0.1 * unit) == Approx(0.2).epsilon(rounding));
    CHECK_FALSE(c.history.past[0].slipping);
    CHECK(after_move(c, -0.29 * unit) == Approx(0.49).epsilon(rounding));
    CHECK(after_move(c, 0.98 * unit) == Approx(-0.49).epsilon(rounding));
    CHECK(after_move(c, 0.1 * unit) == Approx(-kinetic).epsilon(rounding));
}

TEST_CASE("A fresh contact slips from the static limit on", "[contact]") {
    const ContactCase fresh = with_kinetic_friction();
    const double unit = fresh.normal_force() / fresh.pair.tangential_stiffness;
    for (const double move : {0.1, 0.49, 0.51, 1e3}) {
        ContactCase c = fresh;
        CHECK(after_move(c, -move * unit) == Approx(move < held ? move : kinetic).epsilon(rounding));
    }
}

TEST_CASE("Sliding keeps the direction of the spring on the kinetic limit, torsion included", "[contact]") {
    ContactCase c = with_kinetic_friction();
    c.motion = {{0.3, -0.4, 0}, {0, 0, 2}};
    const ContactForce out = c.force();
    CHECK(out.state == ContactState::slip);
    const Vec3 direction = -Vec3(0.3, -0.4, 2 * c.geometry.lever).normalized();
    const double limit = kinetic * c.normal_force();
    CHECK(deviation(out.trial.force, limit * direction, limit) < rounding);
    CHECK(out.moment.z() == Approx(limit * direction.z() * c.geometry.lever).epsilon(rounding));
}

TEST_CASE(
    "Eq. (5.29): the damping of a contact that holds goes up to the static limit, of one that slips to the "
    "kinetic one",
    "[contact]") {
    ContactCase c = with_kinetic_friction();
    c.pair.tangential_damping = 0.5 * std::sqrt(c.pair.tangential_stiffness * 2);
    c.beta_h = 1e-9;  // so short that the spring hardly moves
    c.remember({0.2 * c.normal_force(), 0, 0});
    c.motion.velocity = {-10 * c.normal_force() / c.pair.tangential_damping, 0, 0};
    CHECK(c.force().state == ContactState::stick);
    CHECK(c.force().force.x() == Approx(held * c.normal_force()).epsilon(rounding));
    c.history.past[0].slipping = true;
    CHECK(c.force().state == ContactState::stick);
    CHECK(c.force().force.x() == Approx(kinetic * c.normal_force()).epsilon(rounding));
}

TEST_CASE("Viscous friction, which never holds, goes up to the kinetic limit", "[contact]") {
    ContactCase c = with_kinetic_friction();
    c.pair.tangential_damping = 1e3;
    c.motion.velocity = {-1e3, 0, 0};
    CHECK(c.force_by(FrictionLaw::viscous).force.x() == Approx(kinetic * c.normal_force()).epsilon(rounding));
}

TEST_CASE("The kinetic coefficient of a pair is the smaller, at most the static one, which stands in for it",
          "[contact]") {
    Material a{2600, 1e9, 0.6};
    Material b{2600, 1e9, 0.5};
    const auto constants = [&] { return pair_constants(mix(a, b), {1, 0.1}, {1, 0.1}); };
    CHECK(constants().friction == 0.5);
    CHECK(constants().kinetic_friction == 0.5);
    a.kinetic_friction = 0.4;
    CHECK(constants().kinetic_friction == 0.4);
    a.kinetic_friction = 0.55;
    CHECK(constants().kinetic_friction == 0.5);
    b.kinetic_friction = 0;
    CHECK(constants().kinetic_friction == 0);
    CHECK(constants().friction == 0.5);
}
