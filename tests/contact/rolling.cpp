#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-13;
constexpr double rolling_friction = 0.2;

// A smooth contact, so that nothing but the rolling resistance and the torsion makes a moment.
ContactCase rolling_case() {
    ContactCase c;
    c.geometry.flat_patch = false;
    c.geometry.lever = 0;
    c.pair.rolling_friction = rolling_friction;
    return c;
}

ContactForce force(const ContactCase& c) {
    return c.force_by(FrictionLaw::cundall_strack);
}

// Lc/2 [m].
double radius(const ContactCase& c) {
    return 0.5 * c.pair.length;
}

}  // namespace

TEST_CASE("Rolling is resisted by a spring and a damper of the tangential constants over Lc/2", "[contact]") {
    ContactCase c = rolling_case();
    c.motion.spin = {2e-6, -1e-6, 0};
    const ContactForce out = force(c);
    const double square = radius(c) * radius(c);
    const double by_spring = c.pair.tangential_stiffness * square * c.beta_h;
    const double by_damper = c.pair.tangential_damping * square;
    CHECK_FALSE(out.rolls);
    CHECK(deviation(out.moment, -(by_spring + by_damper) * c.motion.spin, by_spring * 2e-6) < rounding);
    CHECK(deviation(out.trial.rolling, -by_spring / radius(c) * c.motion.spin, by_spring / radius(c) * 2e-6) <
          rounding);
    CHECK(out.force == Vec3(0, 0, out.normal_force));
}

TEST_CASE("The largest rolling moment is μ_r N Lc/2, against the rolling, stored and acting", "[contact]") {
    ContactCase c = rolling_case();
    c.motion.spin = {30, 40, 0};
    const ContactForce out = force(c);
    const double limit = rolling_friction * c.normal_force();
    CHECK(out.rolls);
    CHECK(deviation(out.trial.rolling, -limit * Vec3(0.6, 0.8, 0), limit) < rounding);
    CHECK(deviation(out.moment, -limit * radius(c) * Vec3(0.6, 0.8, 0), limit * radius(c)) < rounding);
    CHECK(out.power.rolling == Approx(limit * radius(c) * 50).epsilon(rounding));
}

TEST_CASE("A rolling spring unloads elastically", "[contact]") {
    ContactCase c = rolling_case();
    const double limit = rolling_friction * c.normal_force();
    const double unit = limit / (c.pair.tangential_stiffness * radius(c) * c.beta_h);  // [rad/s]
    const auto after = [&](double spin) {
        c.motion.spin = {0, spin * unit, 0};
        const ContactForce out = force(c);
        c.history.push(out.trial);
        return out.trial.rolling.y() / limit;
    };
    CHECK(after(0.8) == Approx(-0.8).epsilon(rounding));
    CHECK(after(0.8) == Approx(-1).epsilon(rounding));
    CHECK(after(-0.5) == Approx(-0.5).epsilon(rounding));
    CHECK(after(-1.2) == Approx(0.7).epsilon(rounding));
    CHECK(after(0) == Approx(0.7).epsilon(rounding));
}

TEST_CASE("Turning about n is no rolling, rolling no slip, and both springs keep to themselves",
          "[contact]") {
    ContactCase c = rolling_case();
    c.motion.spin = {0, 0, 3};
    CHECK(force(c).moment == Vec3::Zero());
    c.motion.spin = {0, 1e-6, 0};
    CHECK(force(c).trial.force == Vec3::Zero());
    c.motion = {{1e-6, 0, 0}, Vec3::Zero()};
    CHECK(force(c).trial.rolling == Vec3::Zero());
    c.remember({1, 2, 0});
    c.history.past[0].rolling = {0.5, -0.25, 0};
    c.motion = {};
    CHECK(force(c).trial.force == Vec3(1, 2, 0));
    CHECK(force(c).trial.rolling == Vec3(0.5, -0.25, 0));
}

TEST_CASE("There is rolling resistance without friction, and none where the law or the pair has none",
          "[contact]") {
    ContactCase c = rolling_case();
    c.motion.spin = {0, 1e-6, 0};
    const Vec3 moment = force(c).moment;
    CHECK(moment.y() < 0);
    CHECK(c.force_by(FrictionLaw::none).moment == moment);
    CHECK(c.force_by(FrictionLaw::viscous).moment == moment);
    CHECK(c.force_by(FrictionLaw::cundall_strack_2d).moment == moment);
    CHECK(c.force().moment == Vec3::Zero());
    c.pair.rolling_friction = 0;
    CHECK(force(c).moment == Vec3::Zero());
}

TEST_CASE("The rolling moment of a pair that turns as one turns with it", "[contact]") {
    ContactCase c = rolling_case();
    c.remember(Vec3::Zero());
    c.history.past[0].rolling = {1, 0.5, 0};
    const Quat turn = turned(0.7, Vec3::UnitZ());
    c.turn_a[0] = c.turn_b[0] = turn;
    CHECK(deviation(force(c).trial.rolling, turn * Vec3(1, 0.5, 0), 1) < rounding);
    // Carried round a bend it keeps its length.
    c.geometry.normal = Vec3(0.6, 0, 0.8);
    CHECK(force(c).trial.rolling.norm() == Approx(std::sqrt(1.25)).epsilon(rounding));
    CHECK(std::abs(force(c).trial.rolling.dot(c.geometry.normal)) < rounding);
}
