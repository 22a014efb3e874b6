#include <cmath>

#include <catch2/catch.hpp>

#include <scree/contact/tangential_constants.hpp>
#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-12;

// γt √(kt M) of a case, by the force at a slip of the given velocity, over √(kt).
double mass_of(ContactCase c, ReducedMass kind) {
    c.options.reduced_mass = kind;
    c.pair.friction = 1e9;
    const ContactForce out = c.force();
    const Vec3 damping = out.force - out.force.dot(c.geometry.normal) * c.geometry.normal - out.trial.force;
    const double constant = damping.norm() / c.motion.velocity.norm();
    const double gamma = 0.5;
    return std::pow(constant / gamma, 2) / c.pair.tangential_stiffness;
}

// The matrix K of the source's derivation, Eqs. (5.22) to (5.26).
Mat3 contact_matrix(const ContactCase& c) {
    const auto turning = [](const Vec3& arm, const Quat& frame, const Vec3& inverse) -> Mat3 {
        const Mat3 axes = frame.toRotationMatrix();
        const Mat3 inverse_inertia = axes * inverse.asDiagonal() * axes.transpose();
        return -cross_matrix(arm) * inverse_inertia * cross_matrix(arm);
    };
    return Mat3::Identity() / c.pair.reduced_mass +
           turning(c.arms.a, c.arms.frame_a, c.pair.inverse_inertia_a) +
           turning(c.arms.b, c.arms.frame_b, c.pair.inverse_inertia_b);
}

ContactCase of_bodies(const BodySize& a, const BodySize& b) {
    ContactCase c;
    c.pair = pair_constants({1e7, 0.5, 0.5, 0.5, 2.0 / 7, true}, a, b);
    c.pair.torsion = false;
    c.geometry.flat_patch = false;
    return c;
}

}  // namespace

TEST_CASE("Eq. (5.20): round bodies have 1/M = 1/m₁ + 1/m₂ + r₁²/I₁ + r₂²/I₂", "[contact]") {
    const auto sphere = [](double mass, double radius) -> BodySize {
        return {mass, radius, Vec3::Constant(0.4 * mass * radius * radius)};
    };
    // For solid spheres r²/I = 5/2m: 2/7 of the point masses' M_red, whatever their sizes.
    CHECK(round_mass(sphere(2, 0.1), sphere(3, 0.4)) == Approx(2.0 / 7 * 1.2).epsilon(rounding));
    // Eq. (5.27), against a wall.
    CHECK(round_mass(sphere(2, 0.1), {}) == Approx(2.0 / 7 * 2).epsilon(rounding));
    CHECK(round_mass({}, sphere(2, 0.1)) == Approx(2.0 / 7 * 2).epsilon(rounding));
    const BodySize stone{2, 0.1, {0.01, 0.02, 0.03}};
    CHECK(round_mass(stone, {}) == Approx(1 / (0.5 + 0.01 / 0.02)).epsilon(rounding));
    // A body that may not turn is a point.
    CHECK(round_mass({2, 0.1}, {3, 0.1}) == Approx(1.2).epsilon(rounding));
}

TEST_CASE("Eqs. (5.20), (5.28): the damping takes the point's or the round bodies' mass", "[contact]") {
    ContactCase c = of_bodies({2, 0.06, {1e-3, 2e-3, 3e-3}}, {3, 0.07, {4e-3, 4e-3, 4e-3}});
    c.motion.velocity = {1e-6, 2e-6, 0};
    CHECK(mass_of(c, ReducedMass::point) == Approx(1.2).epsilon(rounding));
    const double inverse = 1 / 1.2 + 0.06 * 0.06 / 2e-3 + 0.07 * 0.07 / 4e-3;
    CHECK(mass_of(c, ReducedMass::round) == Approx(1 / inverse).epsilon(rounding));
}

TEST_CASE("Eqs. (5.22) to (5.26): the exact mass is 1/tᵀKt along the slip", "[contact]") {
    Random random(191);
    for (int i = 0; i < 200; ++i) {
        ContactCase c = random_case(random);
        c.history.clear();
        c.pair.torsion = false;
        c.pair.tangential_damping = 0.5 * std::sqrt(c.pair.tangential_stiffness * c.pair.reduced_mass);
        c.pair.normal_damping = 0;
        const Vec3& n = c.geometry.normal;
        c.motion.velocity -= c.motion.velocity.dot(n) * n;
        const Vec3 t = c.motion.velocity.normalized();
        CHECK(mass_of(c, ReducedMass::exact) == Approx(1 / t.dot(contact_matrix(c) * t)).epsilon(1e-9));
    }
}

TEST_CASE("For a sphere the exact mass is the round one, in any direction", "[contact]") {
    const double radius = 0.1;
    ContactCase c = of_bodies({2, radius, Vec3::Constant(0.4 * 2 * radius * radius)}, {});
    c.arms.a = {0, 0, -radius};
    for (const double angle : {0.0, 0.7, 2.0}) {
        c.motion.velocity = 1e-6 * Vec3(std::cos(angle), std::sin(angle), 0);
        CHECK(mass_of(c, ReducedMass::exact) == Approx(4.0 / 7).epsilon(rounding));
        CHECK(mass_of(c, ReducedMass::round) == Approx(4.0 / 7).epsilon(rounding));
    }
}

TEST_CASE("A long rod touched at its end yields like a quarter of its mass across, like all of it along",
          "[contact]") {
    const double length = 1;
    const double about = 2 * length * length / 12;
    ContactCase c = of_bodies({2, 0.05, {1e-6 * about, about, about}}, {});  // along x
    c.arms.a = {length / 2, 0, 0};
    c.motion.velocity = {0, 1e-6, 0};
    CHECK(mass_of(c, ReducedMass::exact) == Approx(0.5).epsilon(rounding));
    CHECK(mass_of(c, ReducedMass::point) == Approx(2).epsilon(rounding));
    c.motion.velocity = {1e-6, 0, 0};
    CHECK(mass_of(c, ReducedMass::exact) == Approx(2).epsilon(rounding));
}

TEST_CASE("In pure turning about n the exact mass is the inertia about n over r̄²", "[contact]") {
    Random random(192);
    for (int i = 0; i < 50; ++i) {
        const ContactCase c = random_case(random);
        const Vec3& n = c.geometry.normal;
        const double lever = c.geometry.lever;
        Slip slip;
        slip.velocity = 1e-3 * n;
        slip.lever = lever;
        const FrictionStep step{{std::span(c.past).first(c.order), c.beta_h}, c.turn_a, c.turn_b, c.cap};
        const ContactInput in{c.geometry, c.motion, c.pair, c.history, step, c.arms, nullptr};
        const Vec3 a = c.arms.frame_a.conjugate() * n;
        const Vec3 b = c.arms.frame_b.conjugate() * n;
        const double inverse =
            a.cwiseAbs2().dot(c.pair.inverse_inertia_a) + b.cwiseAbs2().dot(c.pair.inverse_inertia_b);
        CHECK(effective_mass(in, slip).mass == Approx(1 / (inverse * lever * lever)).epsilon(rounding));
        // No slip has no direction.
        CHECK(effective_mass(in, Slip{}).mass == c.pair.reduced_mass);
    }
}
