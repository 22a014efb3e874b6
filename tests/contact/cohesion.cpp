#include <cmath>

#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>
#include <tests/support/solids.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-13;
constexpr double cohesion = 20;  // [N]

ContactCase cohesive_case() {
    ContactCase c;
    c.pair.cohesion = cohesion;
    return c;
}

}  // namespace

TEST_CASE("Cohesion pulls with a steady force while the bodies overlap, at any depth", "[contact]") {
    for (const double depth : {1e-12, 1e-6, 1e-4}) {
        ContactCase c = cohesive_case();
        c.geometry.volume = 0.01 * depth;
        c.geometry.depth = depth;
        const ContactForce out = c.force();
        CHECK(out.normal_force == Approx(c.normal_force() - cohesion).epsilon(rounding));
        CHECK(deviation(out.force, Vec3(0, 0, out.normal_force), cohesion) < rounding);
        CHECK(out.cohesive_energy == Approx(-cohesion * depth).epsilon(rounding));
    }
}

TEST_CASE(
    "The pull is bounded: what parts the bodies faster than the elastic force lets go leaves the cohesion",
    "[contact]") {
    ContactCase c = cohesive_case();
    for (const double speed : {0.1, 10.0, 1e6}) {
        c.motion.velocity = {0, 0, speed};
        const ContactForce out = c.force();
        CHECK(out.normal_force >= -cohesion);
        CHECK(out.state != ContactState::open);
    }
    CHECK(c.force().normal_force == -cohesion);
    CHECK(c.force().power.cohesion == Approx(cohesion * 1e6).epsilon(rounding));
    c.pair.cohesion = 0;
    CHECK(c.force().state == ContactState::open);
}

TEST_CASE("Friction and rolling resistance go by what presses, not by what is left after the pull",
          "[contact]") {
    ContactCase c = cohesive_case();
    c.pair.rolling_friction = 0.1;
    c.geometry.flat_patch = false;
    c.geometry.lever = 0;
    c.geometry.volume = cohesion / c.pair.elastic;  // pressed as much as pulled
    c.motion = {{1, 0, 0}, {0, 50, 0}};
    const ContactForce out = c.force_by(FrictionLaw::cundall_strack);
    CHECK(out.normal_force == Approx(0).margin(rounding * cohesion));
    CHECK(out.force.x() == Approx(-c.pair.friction * cohesion).epsilon(rounding));
    CHECK(out.moment.y() == Approx(-0.1 * cohesion * 0.5 * c.pair.length).epsilon(rounding));
}

TEST_CASE("Cohesion is spread evenly: on a tilted face it acts where the face's axis pierces the ground",
          "[contact]") {
    const double edge = 0.1;
    const double depth = 1e-3;
    const Vec3 face_middle(0.02, -0.01, -depth);
    for (const double tilt : {0.0, 0.002, -0.015}) {
        const Quat turn = turned(tilt, Vec3::UnitX());
        ContactCase c = cohesive_case();
        c.pair.friction = 0;
        c.options.damping = DampingPlace::centroid;
        c.geometry =
            overlap_of(placed(cube(edge), face_middle + turn * Vec3(0, 0, edge / 2), turn), ground()).value();
        const Vec3 axis = turn * Vec3::UnitZ();
        const Vec3 pierced = face_middle + depth / axis.z() * axis;
        const Vec3 expected = (pierced - c.geometry.centroid).cross(Vec3(0, 0, -cohesion));
        CHECK(deviation(c.force().moment, expected, cohesion * edge) < 1e-12);
    }
}

TEST_CASE("With cohesion, too, the power adds up to what the contact takes from the bodies", "[contact]") {
    Random random(211);
    for (int i = 0; i < 200; ++i) {
        ContactCase c = random_case(random);
        c.pair.cohesion = random.uniform(0, 3) * c.normal_force();
        const ContactForce out = c.force();
        const ContactPower& power = out.power;
        const double sum = power.normal_elastic + power.normal_damping + power.tangential +
                           power.tangential_damping + power.torsion + power.rolling + power.cohesion;
        const double work = out.force.dot(c.motion.velocity) + out.moment.dot(c.motion.spin);
        const double size = (c.normal_force() + c.pair.cohesion) * c.motion.velocity.norm();
        CHECK(std::abs(sum + work) < 1e-12 * size);
    }
}

TEST_CASE("The smaller cohesion and rolling friction of two materials hold for the pair", "[contact]") {
    Material a{2600, 1e9, 0.6};
    Material b = a;
    a.cohesion = 3;
    a.rolling_friction = 0.2;
    CHECK(mix(a, b).cohesion == 0);
    CHECK(mix(a, b).rolling_friction == 0);
    b.cohesion = 2;
    b.rolling_friction = 0.5;
    const PairConstants pair = pair_constants(mix(a, b), {1, 0.1}, {1, 0.1});
    CHECK(pair.cohesion == 2);
    CHECK(pair.rolling_friction == 0.2);
}
