#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/contact/carried_force.hpp>
#include <tests/support/contact_case.hpp>
#include <tests/support/order.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-14;

CarriedForce literal(const Vec3& force, const Vec3& old_normal, const Vec3& normal) {
    return carry({force, old_normal}, normal, Quat::Identity(), Quat::Identity(), false, nullptr);
}

}  // namespace

TEST_CASE("Eqs. (5.13), (5.14): a stored force is projected on the new plane and rescaled to its length",
          "[contact]") {
    Random random(111);
    for (int i = 0; i < 100; ++i) {
        const Vec3 old_normal = random.direction();
        const Vec3 stored = old_normal.cross(random.vector());
        const Vec3 normal = (old_normal + 0.5 * random.vector()).normalized();
        const CarriedForce carried = literal(stored, old_normal, normal);
        CHECK(std::abs(carried.force.dot(normal)) < rounding);
        CHECK(carried.force.norm() == Approx(stored.norm()).epsilon(rounding));
        const Vec3 projected = stored - stored.dot(normal) * normal;
        CHECK(deviation(carried.force.normalized(), projected.normalized(), 1) < rounding / projected.norm());
        CHECK_FALSE(carried.lost_direction);
    }
}

TEST_CASE("Eq. (5.13): with the normal unchanged nothing changes", "[contact]") {
    const Vec3 stored(3, -2, 0);
    CHECK(deviation(literal(stored, Vec3::UnitZ(), Vec3::UnitZ()).force, stored, 1) < rounding);
}

TEST_CASE("Eq. (5.14): a force normal to the new plane is counted and starts from zero", "[contact]") {
    const CarriedForce lost = literal({2, 0, 0}, Vec3::UnitZ(), Vec3::UnitX());
    CHECK(lost.lost_direction);
    CHECK(lost.force == Vec3::Zero());
    // Just beyond the threshold it has a direction again, and its whole length.
    const CarriedForce kept = literal({2, 0, 0}, Vec3::UnitZ(), Vec3(1, 1e-5, 0).normalized());
    CHECK_FALSE(kept.lost_direction);
    CHECK(kept.force.norm() == Approx(2).epsilon(1e-9));
    // No force is nothing to lose.
    CHECK_FALSE(literal(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX()).lost_direction);
}

TEST_CASE("Eq. (5.14): the law counts a lost direction and goes on from the increment alone", "[contact]") {
    ContactCase c;
    c.history.push({{0, 0, 1}, Vec3::UnitX()});
    c.motion.velocity = {1e-6, 0, 0};
    const ContactForce out = c.force();
    CHECK(out.lost_direction);
    const double expected = c.beta_h * c.pair.tangential_stiffness * 1e-6;
    CHECK(deviation(out.trial.force, Vec3(-expected, 0, 0), expected) < 1e-12);
    ContactCase fine;
    fine.remember({1, 0, 0});
    CHECK_FALSE(fine.force().lost_direction);
}

TEST_CASE("The stored force keeps its magnitude whatever the turn of the tangent plane, in one step or many",
          "[contact]") {
    // Half a turn about x in steps of any size: a force along y ends along −y, one along x stays.
    for (const int steps : {3, 10, 100}) {
        Vec3 normal = Vec3::UnitZ();
        Vec3 rolling(0, 5, 0);
        Vec3 axial(5, 0, 0);
        for (int i = 1; i <= steps; ++i) {
            const double angle = std::numbers::pi * i / steps;
            const Vec3 next(0, -std::sin(angle), std::cos(angle));
            rolling = literal(rolling, normal, next).force;
            axial = literal(axial, normal, next).force;
            normal = next;
        }
        CHECK(deviation(rolling, Vec3(0, -5, 0), 5) < 1e-13);
        CHECK(deviation(axial, Vec3(5, 0, 0), 5) < 1e-13);
    }
}

TEST_CASE("A pair that turns rigidly about n keeps its inner force, and the literal scheme does not",
          "[contact]") {
    for (const double angle : {1e-3, 0.5, -2.0}) {
        ContactCase c;
        c.history.push({{1, 0.5, 0.3}, Vec3::UnitZ()});  // a torsional part, too
        const Quat turn = turned(angle, Vec3::UnitZ());
        c.turn_a[0] = c.turn_b[0] = turn;
        const Vec3 expected = turn * Vec3(1, 0.5, 0.3);
        CHECK(deviation(c.force().trial.force, expected, 1) < rounding);
        c.options.co_rotation = false;
        CHECK(deviation(c.force().trial.force, Vec3(1, 0.5, 0.3), 1) < rounding);
        CHECK((c.force().trial.force - expected).norm() > 0.5 * std::abs(angle));
    }
}

TEST_CASE("The stored force turns by the mean of the two bodies' turns about n", "[contact]") {
    ContactCase c;
    c.remember({1, 0, 0});
    c.turn_a[0] = turned(0.3, Vec3::UnitZ());
    c.turn_b[0] = turned(-0.1, Vec3::UnitZ()) * turned(1e-9, Vec3::UnitX());
    CHECK(deviation(c.force().trial.force, turned(0.1, Vec3::UnitZ()) * Vec3::UnitX(), 1) < 1e-8);
    CHECK(turn_about(Vec3::UnitZ(), turned(0.7, Vec3::UnitZ())) == Approx(0.7).epsilon(rounding));
    CHECK(turn_about(Vec3::UnitZ(), turned(0.7, Vec3::UnitX())) == 0);
    CHECK(turn_about(Vec3::UnitZ(), turned(0.7, Vec3::UnitX()) * turned(0.2, Vec3::UnitZ())) ==
          Approx(0.2).epsilon(rounding));
}

TEST_CASE(
    "A pair that turns rigidly about any axis keeps its inner force to the order of the formula, and the "
    "literal scheme does not",
    "[contact]") {
    const Vec3 axis = Vec3(0.3, -0.5, 0.8).normalized();
    const Vec3 stored(1, 0.5, 0);
    const double whole = 2.0;  // [rad], in so many equal steps
    const auto error_after = [&](int steps, std::size_t order, bool co_rotation) {
        ContactCase c;
        c.options.co_rotation = co_rotation;
        const double angle = whole / steps;
        const auto turn = [&](int i) { return turned(i * angle, axis); };
        c.history.push({turn(-1) * stored, turn(-1) * Vec3::UnitZ()});
        c.history.push({stored, Vec3::UnitZ()});
        c.order = order;
        c.past = order == 1 ? std::array<double, 5>{1} : std::array<double, 5>{4.0 / 3, -1.0 / 3};
        for (int i = 1; i <= steps; ++i) {
            c.geometry.normal = turn(i) * Vec3::UnitZ();
            c.turn_a[0] = c.turn_b[0] = turn(1);
            c.turn_a[1] = c.turn_b[1] = turn(2);
            c.history.push(c.force().trial);
        }
        return (c.history.past[0].force - turn(steps) * stored).norm();
    };
    for (const std::size_t order : {1, 2}) {
        std::vector<double> errors;
        for (int steps = 40; steps <= 320; steps *= 2) {
            errors.push_back(error_after(steps, order, true));
        }
        CHECK(observed_order(errors) == Approx(order).margin(0.1));
        CHECK(error_after(320, order, false) > 0.5);
    }
}
