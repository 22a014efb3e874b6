#include <cmath>

#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-13;

ContactCase spinning(double spin) {
    ContactCase c;
    c.motion.spin = {0, 0, spin};
    return c;
}

}  // namespace

TEST_CASE("Torsion resists spin about n with the stiffness Yt Lc r̄² and the damping γt √(Yt M_red Lc) r̄²",
          "[contact]") {
    const double spin = 1e-6;
    const ContactCase c = spinning(spin);
    const ContactForce out = c.force();
    const double square = c.geometry.lever * c.geometry.lever;
    const double stored = c.pair.tangential_stiffness * square * c.beta_h * spin;
    const double damping = c.pair.tangential_damping * square * spin;
    CHECK(out.state == ContactState::stick);
    CHECK(deviation(out.moment, Vec3(0, 0, -stored - damping), stored) < rounding);
    CHECK(deviation(out.trial.force, Vec3(0, 0, -stored / c.geometry.lever), stored / c.geometry.lever) <
          rounding);
    CHECK(deviation(out.force, Vec3(0, 0, c.normal_force()), c.normal_force()) < rounding);
}

TEST_CASE("The largest moment about n of a contact that does not slide is μ fn r̄", "[contact]") {
    const ContactCase c = spinning(100);
    const ContactForce out = c.force();
    CHECK(out.state == ContactState::slip);
    CHECK(out.moment.z() == Approx(-c.pair.friction * c.normal_force() * c.geometry.lever).epsilon(rounding));
}

TEST_CASE("Sliding and spinning together scale back radially on the limit surface", "[contact]") {
    ContactCase c = spinning(3);
    c.motion.velocity = {0.2, -0.1, 0};
    const ContactForce out = c.force();
    CHECK(out.state == ContactState::slip);
    const double limit = c.pair.friction * c.normal_force();
    const Vec3 direction = -Vec3(0.2, -0.1, 3 * c.geometry.lever).normalized();
    CHECK(out.force.x() == Approx(limit * direction.x()).epsilon(rounding));
    CHECK(out.force.y() == Approx(limit * direction.y()).epsilon(rounding));
    CHECK(out.moment.z() == Approx(limit * direction.z() * c.geometry.lever).epsilon(rounding));
    CHECK(std::hypot(out.force.head<2>().norm(), out.moment.z() / c.geometry.lever) ==
          Approx(limit).epsilon(rounding));
}

TEST_CASE("A contact that spins fast slides almost freely", "[contact]") {
    ContactCase c = spinning(1000);
    c.motion.velocity = {0.1, 0, 0};
    const double limit = c.pair.friction * c.normal_force();
    CHECK(-c.force().force.x() ==
          Approx(limit * 0.1 / std::hypot(0.1, 1000 * c.geometry.lever)).epsilon(rounding));
}

TEST_CASE("The stored moment grows and shrinks with r̄, and follows the normal", "[contact]") {
    ContactCase c;
    c.history.push({{0, 0, 0.4}, Vec3::UnitZ()});
    CHECK(c.force().moment.z() == Approx(0.4 * c.geometry.lever).epsilon(rounding));
    c.geometry.lever *= 0.5;
    CHECK(c.force().moment.z() == Approx(0.4 * c.geometry.lever).epsilon(rounding));
    c.geometry.normal = Vec3(0.6, 0, 0.8);
    CHECK(deviation(c.force().moment, 0.4 * c.geometry.lever * c.geometry.normal, 0.01) < rounding);
}

TEST_CASE("Spin about an axis across n is no torsion", "[contact]") {
    ContactCase c;
    c.geometry.flat_patch = false;
    c.motion.spin = {3, -2, 0};
    CHECK(c.force().moment == Vec3::Zero());
    CHECK(c.force().trial.force == Vec3::Zero());
}

TEST_CASE(
    "There is no torsion where the material switches it off, the patch has no lever, or the law has none",
    "[contact]") {
    ContactCase off = spinning(1);
    off.pair.torsion = false;
    CHECK(off.force().moment.z() == 0);
    ContactCase smooth = spinning(1);
    smooth.geometry.lever = 0;
    smooth.geometry.flat_patch = false;
    CHECK(smooth.force().moment == Vec3::Zero());
    CHECK(spinning(1).force<LawParts{.torsion = false}>().moment.z() == 0);
    CHECK(spinning(1).force().moment.z() < 0);
}

TEST_CASE("Without torsion friction is the same as with torsion and no spin", "[contact]") {
    ContactCase c;
    c.remember({0.3, 0.1, 0});
    c.motion.velocity = {1e-5, 2e-5, 0};
    const ContactForce with = c.force();
    c.pair.torsion = false;
    CHECK(deviation(c.force().force, with.force, 1) < rounding);
}
