#include <cmath>

#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-13;

Vec3 tangential(const ContactForce& out, const Vec3& normal) {
    return out.force - out.force.dot(normal) * normal;
}

}  // namespace

TEST_CASE("Eq. (5.21): the damping force is −γt √(Yt M_red Lc) v_t, and is not stored", "[contact]") {
    ContactCase c;
    c.remember({0.5, 0, 0});
    const Vec3 velocity(1e-6, -2e-6, 0);
    c.motion.velocity = velocity;
    const ContactForce out = c.force();
    CHECK(out.state == ContactState::stick);
    const Vec3 stored = Vec3(0.5, 0, 0) - c.beta_h * c.pair.tangential_stiffness * velocity;
    const Vec3 damping = -c.pair.tangential_damping * velocity;
    CHECK(deviation(out.trial.force, stored, 1) < rounding);
    CHECK(deviation(tangential(out, c.geometry.normal), stored + damping, 1) < rounding);
}

TEST_CASE("Eq. (5.29): elastic and damping part together are cut off again at μ fn; what is stored is not",
          "[contact]") {
    ContactCase c;
    const double limit = c.pair.friction * c.normal_force();
    c.remember({0, 0.9 * limit, 0});
    c.beta_h = 1e-9;  // so short that the spring hardly moves
    c.motion.velocity = {3 * limit / c.pair.tangential_damping, 0, 0};
    const ContactForce out = c.force();
    CHECK(out.state == ContactState::stick);
    CHECK(deviation(out.trial.force, Vec3(0, 0.9 * limit, 0), limit) < 1e-3);
    const Vec3 together = out.trial.force - c.pair.tangential_damping * c.motion.velocity;
    CHECK(deviation(tangential(out, c.geometry.normal), limit * together.normalized(), limit) < rounding);
}

TEST_CASE("Eq. (5.29): in slip along the stored force damping adds nothing", "[contact]") {
    ContactCase c;
    c.motion.velocity = {1, 0, 0};
    const ContactForce out = c.force();
    CHECK(out.state == ContactState::slip);
    const double limit = c.pair.friction * c.normal_force();
    CHECK(deviation(tangential(out, c.geometry.normal), Vec3(-limit, 0, 0), limit) < rounding);
}

TEST_CASE("Eqs. (5.16), (5.29): nothing ever exceeds the limit surface, stored or acting", "[contact]") {
    Random random(121);
    int stick = 0;
    int slip = 0;
    for (int i = 0; i < 500; ++i) {
        ContactCase c = random_case(random);
        c.geometry.flat_patch = false;  // the moment about n is then friction's alone
        const ContactForce out = c.force();
        const Vec3& n = c.geometry.normal;
        const double limit = c.pair.friction * out.normal_force * (1 + rounding);
        CHECK(out.trial.force.norm() <= limit);
        CHECK(std::hypot(tangential(out, n).norm(), out.moment.dot(n) / c.geometry.lever) <= limit);
        CHECK(out.normal_force >= 0);
        stick += out.state == ContactState::stick;
        slip += out.state == ContactState::slip;
    }
    CHECK(stick > 50);
    CHECK(slip > 50);
}

TEST_CASE("Eq. (5.21): without damping a stuck mass swings on its spring, with it the force rises steadily",
          "[contact]") {
    // A mass pulled by a steady force below the limit, semi-implicit in tiny steps; the damping as strong as
    // the point mass of Eq. (5.28) makes it.
    const auto swing = [](double damping) {
        ContactCase c;
        c.beta_h = 1e-6;
        c.pair.tangential_damping *= damping;
        const double pull = 0.3 * c.pair.friction * c.normal_force();
        double highest = 0;
        double speed = 0;
        for (int i = 0; i < 20000; ++i) {
            c.motion.velocity = {speed, 0, 0};
            const ContactForce out = c.force();
            c.history.push(out.trial);
            speed += c.beta_h / c.pair.reduced_mass * (pull + out.force.x());
            highest = std::max(highest, -out.trial.force.x() / pull);
        }
        return highest;
    };
    CHECK(swing(0) == Approx(2).epsilon(1e-2));  // overshoot of a free oscillator
    CHECK(swing(4) <= 1 + 1e-6);                 // γt = 2: critical
}
