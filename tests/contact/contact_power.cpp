#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

double sum(const ContactPower& power) {
    return power.normal_elastic + power.normal_damping + power.tangential + power.tangential_damping +
           power.torsion + power.rolling;
}

double work_on_bodies(const ContactCase& c, const ContactForce& out) {
    return out.force.dot(c.motion.velocity) + out.moment.dot(c.motion.spin);
}

}  // namespace

TEST_CASE("Where a contact's power goes adds up to what it takes from the bodies", "[contact]") {
    Random random(161);
    for (int i = 0; i < 300; ++i) {
        const ContactCase c = random_case(random);
        const ContactForce out = c.force();
        const double size = c.normal_force() * c.motion.velocity.norm();
        CHECK(std::abs(sum(out.power) + work_on_bodies(c, out)) < 1e-12 * size);
    }
}

TEST_CASE("On a half-space the stored normal energy is (Y/Lc) ∫ depth dV, and its rate completes the sum",
          "[contact]") {
    ContactCase c;
    c.geometry = overlap_of(placed(cube(0.1), {0, 0, 0.0499}), ground()).value();
    CHECK(c.force().normal_energy == Approx(c.pair.elastic * 0.01 * 1e-8 / 2).epsilon(1e-9));
    c.motion = {{1e-3, 2e-3, -3e-2}, {0.1, 0, 0.4}};
    const ContactForce out = c.force();
    const double rate = -c.pair.elastic * c.geometry.volume * c.geometry.normal.dot(c.motion.velocity);
    CHECK(out.power.normal_elastic == 0);
    CHECK(sum(out.power) + rate == Approx(-work_on_bodies(c, out)).epsilon(1e-12));
}

TEST_CASE("Damping only takes energy: on the ground at any motion, tension cut off included", "[contact]") {
    Random random(162);
    ContactCase c;
    c.geometry = overlap_of(placed(cube(0.1), {0, 0, 0.0499}), ground()).value();
    for (int i = 0; i < 300; ++i) {
        c.motion = {random.vector(), 5 * random.vector()};
        const ContactForce out = c.force();
        CHECK(out.power.normal_damping >= 0);
        CHECK(out.power.tangential >= 0);
        CHECK(out.power.torsion >= 0);
        CHECK(out.power.tangential_damping >= -1e-12 * out.power.tangential);
    }
}

TEST_CASE("The stored energies are ½ f²/(Yt Lc), of the tangential, the torsional and the rolling spring",
          "[contact]") {
    ContactCase c;
    c.pair.rolling_friction = 0.1;
    FrictionRecord record{.force = {0.3, 0.1, 0.2}};
    record.rolling = {0, 0.5, 0};
    c.history.push(record);
    const ContactForce out = c.force_by(FrictionLaw::cundall_strack);
    CHECK(out.tangential_energy == Approx(0.5 * 0.10 / c.pair.tangential_stiffness).epsilon(1e-12));
    CHECK(out.torsional_energy == Approx(0.5 * 0.04 / c.pair.tangential_stiffness).epsilon(1e-12));
    CHECK(out.rolling_energy == Approx(0.5 * 0.25 / c.pair.tangential_stiffness).epsilon(1e-12));
}
