#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <tests/contact/law_combinations.hpp>
#include <tests/contact/law_error.hpp>
#include <tests/support/allocations.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-12;

ContactCase square() {
    return face_on_cells(cube(0.1), 0.05);
}

ContactCase disc() {
    return face_on_cells(regular_prism(200, 0.05, 0.1), 0.05);
}

double limit(const ContactCase& c) {
    return c.pair.friction * c.normal_force();
}

// So fast that every cell slips.
constexpr double fast = 1e6;

}  // namespace

TEST_CASE("Cells that all move alike make the force of one point", "[contact]") {
    ContactCase c = square();
    c.motion.velocity = {2e-6, -1e-6, 0};
    const ContactForce on_cells = c.force();
    CHECK(on_cells.state == ContactState::stick);
    c.motion.velocity *= fast;
    const ContactForce slipping = c.force();
    c.cells.reset();
    const ContactForce slipping_at_point = c.force();
    CHECK(slipping.state == ContactState::slip);
    CHECK(deviation(slipping.force, slipping_at_point.force, limit(c)) < rounding);
    c.motion.velocity /= fast;
    CHECK(deviation(on_cells.force, c.force().force, limit(c)) < rounding);
    CHECK(deviation(on_cells.moment, c.force().moment, 0.1 * limit(c)) < rounding);
}

TEST_CASE("The moment against a pure spin is μ N r̄, of which a square has 0.3826 edges and a disc 2R/3",
          "[contact]") {
    for (const auto& [c_at_rest, lever] : {std::pair{square(), 0.038260}, std::pair{disc(), 0.1 / 3}}) {
        ContactCase c = c_at_rest;
        c.motion.spin = {0, 0, 100};
        const ContactForce out = c.force();
        CHECK(out.moment.z() == Approx(-limit(c) * lever).epsilon(1e-3));
        CHECK(Vec3(out.force - out.normal_force * Vec3::UnitZ()).norm() < 1e-3 * limit(c));
        CHECK(out.power.tangential + out.power.tangential_damping ==
              Approx(-100 * out.moment.z()).epsilon(1e-9));
    }
}

TEST_CASE("A disc that slides and spins has Coulomb's force and moment, integrated over it", "[contact]") {
    // ∫ over the disc on a fine grid of polar coordinates.
    const auto exact = [](double ratio) {
        Vec2 sums = Vec2::Zero();
        constexpr int grid = 400;
        for (int i = 0; i < grid; ++i) {
            const double r = (i + 0.5) / grid;
            for (int j = 0; j < grid; ++j) {
                const double angle = 2 * std::numbers::pi * (j + 0.5) / grid;
                const Vec2 v(ratio - r * std::sin(angle), r * std::cos(angle));
                const double share = 2 * r / grid / grid / v.norm();
                sums += share * Vec2(v.x(), r * (v.y() * std::cos(angle) - v.x() * std::sin(angle)));
            }
        }
        return sums;
    };
    for (const double ratio : {0.1, 0.3, 0.653, 1.0, 3.0}) {
        for (const double direction : {0.0, 0.2, 1.0}) {
            ContactCase c = disc();
            const Vec3 along(std::cos(direction), std::sin(direction), 0);
            c.motion = {0.05 * fast * ratio * along, {0, 0, fast}};
            const ContactForce out = c.force();
            const Vec2 expected = exact(ratio);
            CAPTURE(ratio, direction);
            CHECK(-out.force.dot(along) / limit(c) == Approx(expected.x()).margin(0.005));
            CHECK(-out.moment.z() / (0.05 * limit(c)) == Approx(expected.y()).margin(0.005));
        }
    }
}

TEST_CASE("Cells near the middle of a slow spin still stick, and the outer ones unload first", "[contact]") {
    ContactCase c = square();
    const double unit =
        limit(c) / (c.pair.tangential_stiffness * c.beta_h);  // [m/s] to the limit in one step
    c.pair.tangential_damping = 0;
    c.motion.spin = {0, 0, unit / 0.03};
    const ContactForce partial = c.force();
    const auto slipping = partial.cells.front().slipping.count();
    CHECK(slipping > 5);
    CHECK(slipping < PatchCells::count);
    CHECK(partial.state == ContactState::stick);
    c.history.push(partial.trial, partial.cells);
    c.motion.spin *= -0.5;
    const ContactForce back = c.force();
    CHECK(back.cells.front().slipping.none());
    CHECK(std::abs(back.moment.z()) < std::abs(partial.moment.z()));
    c.motion.spin *= -1;
    c.history.push(back.trial, back.cells);
    const ContactForce again = c.force();
    // What was at the limit before is there again: nothing was lost between.
    CHECK(again.moment.z() == Approx(partial.moment.z()).epsilon(1e-9));
}

TEST_CASE("Cells are held by static friction until they slip, and then by the kinetic one", "[contact]") {
    ContactCase c = square();
    c.pair.kinetic_friction = 0.4 * c.pair.friction;
    const double unit = limit(c) / (c.pair.tangential_stiffness * c.beta_h);
    c.pair.tangential_damping = 0;
    c.motion.velocity = {0.9 * unit, 0, 0};
    const ContactForce held = c.force();
    CHECK(held.force.x() == Approx(-0.9 * limit(c)).epsilon(1e-9));
    c.history.push(held.trial, held.cells);
    const ContactForce loose = c.force();
    CHECK(loose.force.x() == Approx(-0.4 * limit(c)).epsilon(1e-9));
    CHECK(loose.state == ContactState::slip);
}

TEST_CASE("A patch that turns as one with its pair keeps its inner forces", "[contact]") {
    ContactCase c = square();
    c.motion.spin = {0, 0, 3e-4};
    c.motion.velocity = {2e-6, 1e-6, 0};
    const ContactForce before = c.force();
    c.history.push(before.trial, before.cells);
    const Quat turn = rotation(Vec3(0, 0, 0.7));
    c.turn_a[0] = c.turn_b[0] = turn;
    c.motion = {};
    c.cells->axis = turn * before.cells.front().axis;
    c.pair.tangential_damping = 0;
    const ContactForce after = c.force();
    CHECK(deviation(after.cells.front().axis, turn * before.cells.front().axis, 1) < rounding);
    for (std::size_t i = 0; i < PatchCells::count; ++i) {
        CHECK(deviation(after.cells.front().force[i], before.cells.front().force[i], limit(c)) < rounding);
    }
}

TEST_CASE("The derivative of friction on cells agrees with differences", "[contact]") {
    Random random(421);
    double worst = 0;
    int sticking = 0;
    int slipping = 0;
    for (const LawCombination& law : law_combinations()) {
        if (law.friction == FrictionLaw::cundall_strack_2d || !law.torsion) {
            continue;
        }
        for (int i = 0; i < 6; ++i) {
            ContactCase c = random_case(random, law, true);
            c.geometry.flat_patch = false;
            if (!c.cells || c.force_by(law.friction).state == ContactState::open) {
                continue;
            }
            if (i % 3 == 0) {
                c.history.clear();
            }
            const auto count = c.force_by(law.friction).cells.front().slipping.count();
            sticking += count < PatchCells::count / 2;
            slipping += count > PatchCells::count / 2;
            worst = std::max(worst, law_error(c, LawPath(random, c), law.friction));
        }
    }
    CHECK(sticking > 20);
    CHECK(slipping > 20);
    CHECK(worst < 1e-8);
}

TEST_CASE("The power of friction on cells adds up, and what is stored never exceeds what was put in",
          "[contact]") {
    Random random(422);
    for (int i = 0; i < 200; ++i) {
        ContactCase c = random_case(random, true);
        if (!c.cells) {
            continue;
        }
        const ContactForce out = c.force();
        const ContactPower& power = out.power;
        const double sum = power.normal_elastic + power.normal_damping + power.tangential +
                           power.tangential_damping + power.torsion;
        const double work = out.force.dot(c.motion.velocity) + out.moment.dot(c.motion.spin);
        CHECK(std::abs(sum + work) < 1e-12 * c.normal_force() * c.motion.velocity.norm());
        CHECK(power.torsion == 0);
        c.history.clear();
        const ContactForce fresh = c.force();
        CHECK(fresh.tangential_energy <= c.beta_h * fresh.power.tangential * (1 + 1e-9));
    }
}

TEST_CASE("Friction on cells takes no new memory in a steady contact", "[contact]") {
    ContactCase c = square();
    c.motion.velocity = {2e-6, -1e-6, 0};
    ContactForce out;
    const auto step = [&] {
        const FrictionStep formula{{std::span(c.past).first(1), c.beta_h}, c.turn_a, c.turn_b};
        BuiltInLaw<LawParts{}>{}(
            {c.geometry, c.motion, c.pair, c.history, formula, c.arms, nullptr, &*c.cells}, out);
        c.history.push(out.trial, out.cells);
    };
    step();
    const AllocationCount allocations;
    for (int i = 0; i < 10; ++i) {
        step();
    }
    CHECK(allocations.count() == 0);
}
