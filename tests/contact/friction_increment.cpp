#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-13;

// The case without tangential damping: what acts is what is stored.
ContactCase undamped() {
    ContactCase c;
    c.pair.tangential_damping = 0;
    return c;
}

}  // namespace

TEST_CASE("Eqs. (5.15), (5.17): a fresh contact's friction is −Yt Lc v_t dt", "[contact]") {
    ContactCase c = undamped();
    c.motion.velocity = {2e-6, -1e-6, 0};
    const ContactForce out = c.force();
    const Vec3 expected = -c.pair.tangential_stiffness * c.beta_h * Vec3(2e-6, -1e-6, 0);
    CHECK(out.state == ContactState::stick);
    CHECK(deviation(out.trial.force, expected, expected.norm()) < rounding);
    CHECK(deviation(out.force, expected + Vec3(0, 0, c.normal_force()), c.normal_force()) < rounding);
}

TEST_CASE("Eq. (5.15): only the part of the velocity across n counts", "[contact]") {
    ContactCase c = undamped();
    c.motion.velocity = {2e-6, 0, -1e-3};
    const double expected = c.pair.tangential_stiffness * c.beta_h * 2e-6;
    CHECK(deviation(c.force().trial.force, Vec3(-expected, 0, 0), expected) < rounding);
}

TEST_CASE("Eq. (5.15): the increment is added to what is stored", "[contact]") {
    ContactCase c = undamped();
    c.remember({1, 2, 0});
    c.motion.velocity = {2e-6, 0, 0};
    const double increment = c.pair.tangential_stiffness * c.beta_h * 2e-6;
    CHECK(deviation(c.force().trial.force, Vec3(1 - increment, 2, 0), 2) < rounding);
}

TEST_CASE("Eq. (5.16): what is stored is cut off at μ fn, its direction kept", "[contact]") {
    ContactCase c = undamped();
    c.remember({3, 4, 0});
    c.motion.velocity = {-3, -4, 0};
    const ContactForce out = c.force();
    CHECK(out.state == ContactState::slip);
    const double limit = c.pair.friction * c.normal_force();
    CHECK(deviation(out.trial.force, limit * Vec3(0.6, 0.8, 0), limit) < rounding);
    CHECK(deviation(out.force, limit * Vec3(0.6, 0.8, 0) + Vec3(0, 0, c.normal_force()), limit) < rounding);
    CHECK(out.trial.normal == c.geometry.normal);
}

TEST_CASE("Eq. (5.16): a stored force above the limit of a lighter load is cut off though nothing moves",
          "[contact]") {
    ContactCase c = undamped();
    c.remember({0.9 * c.pair.friction * c.normal_force(), 0, 0});
    CHECK(c.force().state == ContactState::stick);
    c.geometry.volume *= 0.5;
    const ContactForce out = c.force();
    CHECK(out.state == ContactState::slip);
    CHECK(out.trial.force.norm() == Approx(c.pair.friction * c.normal_force()).epsilon(rounding));
}

TEST_CASE(
    "Eqs. (5.11), (5.12): in a plane the force is the signed scalar increment with cut-off, unloading "
    "included",
    "[contact]") {
    ContactCase c = undamped();
    const double limit = c.pair.friction * c.normal_force();
    double scalar = 0;
    int stick = 0;
    int slip = 0;
    for (int i = 0; i < 400; ++i) {
        const double speed = 0.01 * std::sin(0.05 * i);  // to and fro, into slip on either side
        c.motion.velocity = {0, speed, 0};
        const double free = scalar - c.pair.tangential_stiffness * c.beta_h * speed;
        scalar = std::clamp(free, -limit, limit);
        (scalar == free ? stick : slip) += 1;
        const ContactForce out = c.force();
        CHECK(deviation(out.trial.force, Vec3(0, scalar, 0), limit) < 1e-12);
        c.history.push(out.trial);
    }
    CHECK(stick > 50);
    CHECK(slip > 50);
}

TEST_CASE("Eq. (5.15) at order two takes 4/3 of the last force less 1/3 of the one before", "[contact]") {
    ContactCase c = undamped();
    c.remember({3, 0, 0});
    c.remember({4, 1, 0});
    c.order = 2;
    c.past = {4.0 / 3, -1.0 / 3};
    CHECK(deviation(c.force().trial.force, Vec3(13.0 / 3, 4.0 / 3, 0), 1) < rounding);
}

TEST_CASE("A contact uses no more of the past than it has", "[contact]") {
    ContactCase c = undamped();
    c.order = 2;
    c.past = {4.0 / 3, -1.0 / 3};
    c.history.past[0].force = {7, 7, 0};  // left over from before, of age zero
    c.motion.velocity = {1e-6, 0, 0};
    const double expected = c.pair.tangential_stiffness * c.beta_h * 1e-6;
    CHECK(deviation(c.force().trial.force, Vec3(-expected, 0, 0), expected) < rounding);
}

TEST_CASE("The history keeps the latest first, no more than five, and forgets when cleared", "[contact]") {
    ContactHistory history;
    for (int i = 1; i <= 7; ++i) {
        history.push({Vec3(i, 0, 0), Vec3::UnitZ()});
    }
    CHECK(history.age == highest_order);
    for (std::size_t j = 0; j < highest_order; ++j) {
        CHECK(history.past[j].force.x() == 7.0 - static_cast<double>(j));
    }
    history.centre_line = true;
    history.clear();
    CHECK(history.age == 0);
    CHECK_FALSE(history.centre_line);
}

TEST_CASE("Without friction there is the normal force alone", "[contact]") {
    ContactCase c;
    c.pair.friction = 0;
    c.remember({1, 0, 0});
    c.motion = {{0.1, 0, 0}, {0, 0, 5}};
    const ContactForce out = c.force();
    CHECK(out.state == ContactState::slip);
    CHECK(out.force == Vec3(0, 0, out.normal_force));
    CHECK(out.trial.force == Vec3::Zero());
    c.pair.friction = 0.5;
    const ContactForce without = c.force<LawParts{FrictionLaw::none, false}>();
    CHECK(without.force == out.force);
    CHECK(without.moment == out.moment);
}

TEST_CASE("A cap κ limits the stiffness to κ M_red/(βh)² and the damping to κ M_red/(βh)", "[contact]") {
    ContactCase c;
    c.cap = 0.1;
    c.motion.velocity = {1e-4, 0, 0};
    const double mass = c.pair.reduced_mass;
    REQUIRE(c.pair.tangential_stiffness > 0.1 * mass / (c.beta_h * c.beta_h));
    REQUIRE(c.pair.tangential_damping > 0.1 * mass / c.beta_h);
    const double stored = 0.1 * mass / c.beta_h * 1e-4;
    CHECK(c.force().trial.force.x() == Approx(-stored).epsilon(rounding));
    CHECK(c.force().force.x() == Approx(-2 * stored).epsilon(rounding));
    c.cap = 1e12;  // above both
    ContactCase plain = c;
    plain.cap = std::numeric_limits<double>::infinity();
    CHECK(c.force().force == plain.force().force);
}
