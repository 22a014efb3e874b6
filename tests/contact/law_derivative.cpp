#include <catch2/catch.hpp>

#include <tests/contact/law_combinations.hpp>
#include <tests/contact/law_error.hpp>

using namespace scree;
using namespace scree::test;

namespace {

enum class Regime { stick, damped_to_the_limit, slip };

Regime regime_of(const ContactCase& c) {
    const ContactForce out = c.force();
    if (out.state == ContactState::slip) {
        return Regime::slip;
    }
    const Vec3& n = c.geometry.normal;
    const Vec3 slip = c.motion.velocity - c.motion.velocity.dot(n) * n +
                      (c.pair.torsion ? c.geometry.lever : 0) * c.motion.spin.dot(n) * n;
    const Vec3 together = out.trial.force - c.pair.tangential_damping * slip;
    return together.norm() > c.pair.friction * out.normal_force ? Regime::damped_to_the_limit : Regime::stick;
}

// Checks random contacts until each regime had its share.
void check_regimes(Random& random, bool co_rotation, bool torsion) {
    std::array<int, 3> seen{};
    double worst = 0;
    for (int i = 0; i < 400; ++i) {
        ContactCase c = random_case(random);
        c.geometry.flat_patch = false;
        c.options.co_rotation = co_rotation;
        c.pair.torsion = torsion;
        c.pair.tangential_damping *= 5;
        if (i % 2 == 0) {
            c.motion = {0.1 * c.motion.velocity, 0.1 * c.motion.spin};
            c.history.past[0].force *= 0.3;
            c.history.past[1].force *= 0.3;
        }
        if (c.force().state == ContactState::open) {
            continue;
        }
        ++seen[static_cast<std::size_t>(regime_of(c))];
        worst = std::max(worst, law_error(c, LawPath(random, c)));
    }
    for (const int count : seen) {
        CHECK(count > 30);
    }
    CHECK(worst < 1e-8);  // central differences: some 10⁻¹⁰ of smooth functions
}

}  // namespace

TEST_CASE("The law's derivative agrees with differences in stick, at the second cut-off and in slip",
          "[contact]") {
    Random random(141);
    SECTION("with torsion and the pair's own rotation") {
        check_regimes(random, true, true);
    }
    SECTION("with torsion, the literal scheme") {
        check_regimes(random, false, true);
    }
    SECTION("without torsion") {
        check_regimes(random, true, false);
    }
}

TEST_CASE("The damping traction's derivative follows the motion; the patch's own change is left out",
          "[contact]") {
    Random random(142);
    double worst = 0;
    for (int i = 0; i < 50; ++i) {
        const ContactCase c = random_case(random);
        if (c.force().state != ContactState::open) {
            worst = std::max(worst, law_error(c, LawPath(random, c, false)));
        }
    }
    CHECK(worst < 1e-8);
}

TEST_CASE("Without friction the law's derivative agrees with differences", "[contact]") {
    Random random(143);
    for (int i = 0; i < 20; ++i) {
        ContactCase c = random_case(random);
        c.pair.friction = 0;
        c.geometry.flat_patch = false;
        CHECK(law_error(c, LawPath(random, c)) < 1e-8);
    }
}

TEST_CASE("A contact that starts afresh, or has lost its direction, has the right derivative", "[contact]") {
    Random random(144);
    ContactCase fresh = random_case(random);
    fresh.geometry.flat_patch = false;
    fresh.history.clear();
    CHECK(law_error(fresh, LawPath(random, fresh)) < 1e-8);
    ContactCase capped = random_case(random);
    capped.geometry.flat_patch = false;
    capped.cap = 0.1;
    CHECK(law_error(capped, LawPath(random, capped)) < 1e-8);
    ContactCase lost = random_case(random);
    lost.geometry.flat_patch = false;
    lost.order = 1;
    lost.past = {1};
    lost.history.past[0] = {lost.geometry.normal, lost.geometry.normal.unitOrthogonal()};
    REQUIRE(lost.force().lost_direction);
    CHECK(law_error(lost, LawPath(random, lost, false)) < 1e-8);  // any tilt would find it again
}

TEST_CASE("Every choice of the law has its derivative, in stick and in slip", "[contact]") {
    Random random(145);
    for (const LawCombination& law : law_combinations()) {
        CAPTURE(law.name());
        int stick = 0;
        int slip = 0;
        double worst = 0;
        for (int i = 0; i < 24; ++i) {
            ContactCase c = random_case(random, law);
            c.geometry.flat_patch = false;
            const ContactState state = c.force_by(law.friction).state;
            if (state != ContactState::open) {
                worst = std::max(worst, law_error(c, LawPath(random, c), law.friction));
                stick += state == ContactState::stick;
                slip += state == ContactState::slip;
            }
        }
        CHECK(stick >= 1);
        CHECK(slip >= 1);
        CHECK(worst < 1e-8);
    }
}
