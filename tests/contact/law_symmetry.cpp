#include <cmath>

#include <catch2/catch.hpp>

#include <tests/contact/seen_from_b.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// The same contact in other axes.
ContactCase turned_case(const ContactCase& c, const Quat& turn) {
    ContactCase other = c;
    rotate(other.geometry, turn.toRotationMatrix());
    other.motion = {turn * c.motion.velocity, turn * c.motion.spin};
    for (FrictionRecord& record : other.history.past) {
        record.force = turn * record.force;
        record.rolling = turn * record.rolling;
        record.normal = turn * record.normal;
    }
    other.arms = {turn * c.arms.a, turn * c.arms.b, turn * c.arms.frame_a, turn * c.arms.frame_b};
    for (std::size_t j = 0; j < highest_order; ++j) {
        other.turn_a[j] = turn * c.turn_a[j] * turn.conjugate();
        other.turn_b[j] = turn * c.turn_b[j] * turn.conjugate();
    }
    return other;
}

constexpr double rounding = 1e-12;  // of the normal force; the patch's moments cancel a few digits

}  // namespace

TEST_CASE("Exchanging the bodies flips force, moment and record exactly, torsion included", "[contact]") {
    Random random(151);
    for (int i = 0; i < 300; ++i) {
        const ContactCase c = random_case(random);
        const ContactForce on_a = c.force();
        const ContactForce on_b = seen_from_b(c).force();
        const double size = on_a.normal_force + c.normal_force();
        CHECK(on_a.state == on_b.state);
        CHECK(deviation(on_b.force, -on_a.force, size) < rounding);
        CHECK(deviation(on_b.moment, -on_a.moment, size * 0.1) < rounding);
        CHECK(deviation(on_b.trial.force, -on_a.trial.force, size) < rounding);
        CHECK(on_a.lost_direction == on_b.lost_direction);
        CHECK(std::abs(on_b.power.normal_damping - on_a.power.normal_damping) < rounding * size);
        CHECK(std::abs(on_b.power.tangential - on_a.power.tangential) < rounding * size);
    }
}

TEST_CASE("The law does not depend on the axes", "[contact]") {
    Random random(152);
    for (int i = 0; i < 300; ++i) {
        const ContactCase c = random_case(random);
        const Quat turn = random.rotation();
        const ContactForce out = c.force();
        const ContactForce other = turned_case(c, turn).force();
        const double size = out.normal_force + c.normal_force();
        CHECK(out.state == other.state);
        CHECK(deviation(other.force, turn * out.force, size) < rounding);
        CHECK(deviation(other.moment, turn * out.moment, size * 0.1) < rounding);
        CHECK(deviation(other.trial.force, turn * out.trial.force, size) < rounding);
    }
}

TEST_CASE("Friction opposes slip in any direction alike", "[contact]") {
    ContactCase c;
    c.pair.torsion = false;
    for (const double angle : {0.0, 0.3, 1.0, 2.5}) {
        const Vec3 way(std::cos(angle), std::sin(angle), 0);
        c.motion.velocity = way;
        const Vec3 expected = -c.pair.friction * c.normal_force() * way;
        CHECK(deviation(c.force().force, expected + Vec3(0, 0, c.normal_force()), c.normal_force()) <
              rounding);
    }
}
