// What holds for every choice of the law.

#include <catch2/catch.hpp>

#include <tests/contact/law_combinations.hpp>
#include <tests/contact/law_path.hpp>
#include <tests/contact/seen_from_b.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-12;  // of the normal force; the patch's moments cancel a few digits

}  // namespace

TEST_CASE("Under every choice exchanging the bodies flips force, moment and record", "[contact]") {
    Random random(201);
    for (const LawCombination& law : law_combinations()) {
        CAPTURE(law.name());
        double worst = 0;
        for (int i = 0; i < 10; ++i) {
            const ContactCase c = random_case(random, law);
            const ContactForce on_a = c.force_by(law.friction);
            const ContactForce on_b = seen_from_b(c).force_by(law.friction);
            const double size = on_a.normal_force + c.normal_force();
            REQUIRE(on_a.state == on_b.state);
            worst = std::max({worst, deviation(on_b.force, -on_a.force, size),
                              deviation(on_b.moment, -on_a.moment, 0.1 * size),
                              deviation(on_b.trial.force, -on_a.trial.force, size),
                              deviation(on_b.trial.rolling, -on_a.trial.rolling, size)});
        }
        CHECK(worst < rounding);
    }
}

TEST_CASE("Under every choice the power adds up to what the contact takes from the bodies", "[contact]") {
    Random random(202);
    for (const LawCombination& law : law_combinations()) {
        CAPTURE(law.name());
        double worst = 0;
        for (int i = 0; i < 10; ++i) {
            const ContactCase c = random_case(random, law);
            const ContactForce out = c.force_by(law.friction);
            const ContactPower& power = out.power;
            const double sum = power.normal_elastic + power.normal_damping + power.tangential +
                               power.tangential_damping + power.torsion + power.rolling + power.cohesion;
            const double work = out.force.dot(c.motion.velocity) + out.moment.dot(c.motion.spin);
            const double size = (c.normal_force() + out.normal_force) *
                                (c.motion.velocity.norm() + c.geometry.lever * c.motion.spin.norm());
            worst = std::max(worst, std::abs(sum + work) / size);
        }
        CHECK(worst < rounding);
    }
}

TEST_CASE("Under every choice nothing exceeds the limit surface, stored or acting", "[contact]") {
    Random random(203);
    for (const LawCombination& law : law_combinations()) {
        CAPTURE(law.name());
        for (int i = 0; i < 10; ++i) {
            ContactCase c = random_case(random, law);
            c.geometry.flat_patch = false;  // the moment about n is then friction's alone
            const ContactForce out = c.force_by(law.friction);
            const Vec3& n = c.geometry.normal;
            const Vec3 sideways = out.force - out.force.dot(n) * n;
            const double pressing = out.normal_force + c.pair.cohesion;
            const double limit = c.pair.friction * pressing * (1 + 1e-13) + 1e-15 * out.force.norm();
            const double most = c.pair.rolling_friction * pressing * (1 + 1e-13);
            CHECK(out.trial.force.norm() <= limit);
            CHECK(out.trial.rolling.norm() <= most);
            if (c.pair.cohesion == 0) {  // which has a moment of its own
                const double turning = (out.moment - out.moment.dot(n) * n).norm();
                CHECK(std::hypot(sideways.norm(), out.moment.dot(n) / c.geometry.lever) <= limit);
                CHECK(turning <= 0.5 * c.pair.length * most + 1e-15 * out.moment.norm());
            }
        }
    }
}

TEST_CASE("Under every choice asking for derivatives changes no force, and asking again nothing at all",
          "[contact]") {
    Random random(204);
    for (const LawCombination& law : law_combinations()) {
        CAPTURE(law.name());
        const ContactCase c = random_case(random, law);
        const MotionRates rates = LawPath(random, c).rates(c);
        const ContactForce with = c.force_by(law.friction, &rates);
        const ContactForce again = c.force_by(law.friction, &rates);
        const ContactForce without = c.force_by(law.friction);
        CHECK(with.force == without.force);
        CHECK(with.moment == without.moment);
        CHECK(with.trial.force == without.trial.force);
        CHECK(again.force_rate == with.force_rate);
        CHECK(again.moment_rate == with.moment_rate);
    }
}

TEST_CASE("Damping at the centroid is the same force without the patch's moment", "[contact]") {
    Random random(205);
    for (int i = 0; i < 50; ++i) {
        ContactCase c = random_case(random);
        c.pair.friction = 0;
        const ContactForce patch = c.force();
        c.options.damping = DampingPlace::centroid;
        const ContactForce centroid = c.force();
        CHECK(centroid.force == patch.force);
        CHECK(centroid.moment == Vec3::Zero());
        CHECK((patch.moment.norm() > 0 || patch.normal_force == 0));
    }
}
