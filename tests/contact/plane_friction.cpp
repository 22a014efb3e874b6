#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include <scree/contact/carried_force.hpp>
#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-13;
constexpr FrictionLaw in_plane = FrictionLaw::cundall_strack_2d;

// The normal of the x–z plane that is turned by an angle about y from z.
Vec3 normal_at(double angle) {
    return {std::sin(angle), 0, std::cos(angle)};
}

// A contact whose motion, past and turns lie in the x–z plane, half of them slipping.
ContactCase plane_case(Random& random) {
    ContactCase c;
    const double angle = random.uniform(-3, 3);
    c.geometry.normal = normal_at(angle);
    c.geometry.area_vector = -c.geometry.area * c.geometry.normal;
    c.geometry.flat_patch = false;
    c.order = 2;
    c.past = {4.0 / 3, -1.0 / 3};
    const double force = c.pair.friction * c.normal_force();
    const double speed = force / (c.pair.tangential_stiffness * c.beta_h);
    c.motion = {speed * Vec3(random.uniform(-1, 1), 0, random.uniform(-0.01, 0.01)),
                Vec3(0, random.uniform(-5, 5), 0)};
    for (std::size_t j = 0; j < 2; ++j) {
        const double old = angle + random.uniform(-1, 1);  // [rad]
        c.history.push({force * random.uniform(-1, 1) * plane_tangent(normal_at(old)), normal_at(old)});
        c.turn_a[j] = turned(random.uniform(-1, 1), Vec3::UnitY());
        c.turn_b[j] = turned(random.uniform(-1, 1), Vec3::UnitY());
    }
    return c;
}

}  // namespace

TEST_CASE("Eq. (5.12): a signed number along e_y × n, with increments −kt v_t dt and the cut-off ±μ fn",
          "[contact]") {
    ContactCase c;
    c.pair.tangential_damping = 0;
    const double limit = c.pair.friction * c.normal_force();
    double number = 0;
    bool cut = false;
    bool unloaded = false;
    for (int i = 0; i < 400; ++i) {
        const double speed = 0.01 * std::sin(0.05 * i);  // to and fro, into slip on either side
        c.motion.velocity = {speed, 1e-3, 0};            // across the plane there is no friction
        const double free = number - c.pair.tangential_stiffness * c.beta_h * speed;
        number = std::clamp(free, -limit, limit);
        cut = cut || free != number;
        unloaded = unloaded || (number * speed > 0 && std::abs(number) < limit);  // Eq. (5.10) cannot
        const ContactForce out = c.force_by(in_plane);
        CHECK(deviation(out.trial.force, Vec3(number, 0, 0), limit) < 1e-12);
        CHECK(out.force.y() == 0);
        c.history.push(out.trial);
    }
    CHECK(cut);
    CHECK(unloaded);
}

TEST_CASE("In plane motion the law in two dimensions gives what the one in three does", "[contact]") {
    Random random(171);
    int slip = 0;
    for (int i = 0; i < 300; ++i) {
        const ContactCase c = plane_case(random);
        const ContactForce two = c.force_by(in_plane);
        const ContactForce three = c.force();
        const double size = c.normal_force();
        CHECK(deviation(two.force, three.force, size) < rounding);
        CHECK(deviation(two.moment, three.moment, size) < rounding);
        CHECK(deviation(two.trial.force, three.trial.force, size) < rounding);
        CHECK(two.state == three.state);
        CHECK(two.tangential_energy == Approx(three.tangential_energy).epsilon(1e-12));
        CHECK(two.power.tangential == Approx(three.power.tangential).epsilon(1e-10));
        slip += two.state == ContactState::slip;
    }
    CHECK(slip > 50);
    CHECK(slip < 250);
}

TEST_CASE("Fig. 5.17: the stored force keeps its magnitude and its sense whatever the turn of the tangent",
          "[contact]") {
    // Once around, in steps of a few degrees or of 120.
    for (const int steps : {3, 4, 7, 100}) {
        FrictionRecord record{5 * Vec3::UnitX(), Vec3::UnitZ()};
        for (int i = 1; i <= steps; ++i) {
            const Vec3 normal = normal_at(2 * std::numbers::pi * i / steps);
            const CarriedForce carried = carry_in_plane(record, normal, nullptr);
            CHECK(carried.force.dot(plane_tangent(normal)) == Approx(5).epsilon(rounding));
            CHECK(carried.force.norm() == Approx(5).epsilon(rounding));
            CHECK_FALSE(carried.lost_direction);
            record = {carried.force, normal};
        }
        CHECK(deviation(record.force, Vec3(5, 0, 0), 5) < rounding);
    }
}

TEST_CASE("Where the tangent turns by 90 degrees in one step, Eq. (5.13) has no direction and Eq. (5.12) has",
          "[contact]") {
    const FrictionRecord record{Vec3::UnitX(), Vec3::UnitZ()};
    const auto three = [&](double angle) {
        return carry(record, normal_at(angle), Quat::Identity(), Quat::Identity(), true, nullptr);
    };
    const auto two = [&](double angle) { return carry_in_plane(record, normal_at(angle), nullptr); };
    const double right = std::numbers::pi / 2;
    CHECK(three(right).lost_direction);
    CHECK(deviation(two(right).force, Vec3(0, 0, -1), 1) < rounding);
    // Short of it they agree, beyond it the projection has the other sense.
    CHECK(deviation(two(right - 0.1).force, three(right - 0.1).force, 1) < rounding);
    CHECK(deviation(two(right + 0.1).force, -three(right + 0.1).force, 1) < rounding);
}

TEST_CASE("A normal along y has no tangent in the plane, and then there is no friction", "[contact]") {
    ContactCase c;
    c.remember({1, 0, 0});
    c.motion.velocity = {1, 0, 0};
    c.geometry.normal = Vec3::UnitY();
    const ContactForce out = c.force_by(in_plane);
    CHECK(out.force == Vec3(0, out.normal_force, 0));
    CHECK(out.lost_direction);
    CHECK(out.trial.force == Vec3::Zero());
}
