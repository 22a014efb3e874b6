#include <cmath>

#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-13;
constexpr FrictionLaw viscous = FrictionLaw::viscous;

// The speed at which the damper alone reaches μ fn.
double limit_speed(const ContactCase& c) {
    return c.pair.friction * c.normal_force() / c.pair.tangential_damping;
}

}  // namespace

TEST_CASE("Viscous friction is −γt √(Yt M_red Lc) v_t up to μ fn, and remembers nothing", "[contact]") {
    ContactCase c;
    const double limit = c.pair.friction * c.normal_force();
    for (const double share : {0.0, 1e-6, 0.5, 0.999}) {
        c.motion.velocity = share * limit_speed(c) * Vec3(0.6, -0.8, 0);
        const ContactForce out = c.force_by(viscous);
        CHECK(out.state == ContactState::stick);
        CHECK(deviation(out.force, Vec3(-0.6 * share * limit, 0.8 * share * limit, out.normal_force), limit) <
              rounding);
        CHECK(out.trial.force == Vec3::Zero());
        CHECK(out.tangential_energy == 0);
    }
    for (const double share : {1.001, 10.0, 1e9}) {
        c.motion.velocity = share * limit_speed(c) * Vec3(0.6, -0.8, 0);
        const ContactForce out = c.force_by(viscous);
        CHECK(out.state == ContactState::slip);
        CHECK(deviation(out.force, Vec3(-0.6 * limit, 0.8 * limit, out.normal_force), limit) < rounding);
    }
}

TEST_CASE("Viscous friction does not ask for the past", "[contact]") {
    ContactCase fresh;
    fresh.motion.velocity = {1e-4, 2e-4, 0};
    ContactCase old = fresh;
    old.remember({3, 1, 0.5});
    CHECK(old.force_by(viscous).force == fresh.force_by(viscous).force);
    CHECK(old.force_by(viscous).moment == fresh.force_by(viscous).moment);
}

TEST_CASE("Viscous torsion is −γt √(Yt M_red Lc) r̄² ω_n up to μ fn r̄", "[contact]") {
    ContactCase c;
    const double lever = c.geometry.lever;
    c.motion.spin = {0, 0, 0.5 * limit_speed(c) / lever};
    CHECK(c.force_by(viscous).moment.z() ==
          Approx(-0.5 * c.pair.friction * c.normal_force() * lever).epsilon(rounding));
    c.motion.spin *= 1000;
    CHECK(c.force_by(viscous).moment.z() ==
          Approx(-c.pair.friction * c.normal_force() * lever).epsilon(rounding));
    c.pair.torsion = false;
    CHECK(c.force_by(viscous).moment.z() == 0);
}

TEST_CASE("What viscous friction takes is damping below μ fn, and friction at it", "[contact]") {
    ContactCase c;
    c.motion.velocity = {0.5 * limit_speed(c), 0, 0};
    const ContactForce below = c.force_by(viscous);
    CHECK(below.power.tangential == 0);
    CHECK(below.power.tangential_damping ==
          Approx(c.pair.tangential_damping * c.motion.velocity.squaredNorm()).epsilon(rounding));
    c.motion.velocity = {2 * limit_speed(c), 0, 0};
    const ContactForce at_limit = c.force_by(viscous);
    CHECK(at_limit.power.tangential_damping == 0);
    CHECK(at_limit.power.tangential ==
          Approx(c.pair.friction * c.normal_force() * c.motion.velocity.norm()).epsilon(rounding));
}
