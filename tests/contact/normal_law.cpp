#include <cmath>

#include <catch2/catch.hpp>

#include <tests/support/contact_case.hpp>
#include <tests/support/overlaps.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double rounding = 1e-13;
constexpr double edge = 0.1;

// The case of a cube's face on the ground, sunk in and tilted about the middle of its face.
ContactCase cube_on_ground(double depth, double tilt = 0) {
    const Quat turn = turned(tilt, Vec3::UnitX());
    const Vec3 face_middle(0, 0, -depth);
    ContactCase c;
    c.geometry =
        overlap_of(placed(cube(edge), face_middle + turn * Vec3(0, 0, edge / 2), turn), ground()).value();
    return c;
}

}  // namespace

TEST_CASE("Eq. (5.7): a face contact is a linear spring k = Y A/Lc along n", "[contact]") {
    for (const double depth : {1e-9, 1e-6, 1e-3}) {
        const ContactCase c = cube_on_ground(depth);
        const double stiffness = c.pair.elastic * edge * edge;
        const ContactForce out = c.force();
        CHECK(out.normal_force == Approx(stiffness * depth).epsilon(1e-15 * edge / depth + rounding));
        CHECK(deviation(out.force, Vec3(0, 0, out.normal_force), out.normal_force) < rounding);
        CHECK(out.state != ContactState::open);
    }
}

TEST_CASE("Eq. (5.7): the damping force is γn √(Y M_red/Lc³) V̇, which gives ζ = γn √A/(2 Lc)", "[contact]") {
    ContactCase c = cube_on_ground(1e-4);
    const PairMaterial material{1e7, 0, 0.7, 0.5, 2.0 / 7, true};
    c.pair = pair_constants(material, {2, 0.06}, {3, 0.08});
    const double elastic = c.force().normal_force;
    const double speed = 0.01;
    c.motion.velocity = {0, 0, -speed};
    const double damping = (c.force().normal_force - elastic) / speed;
    const double stiffness = c.pair.elastic * edge * edge;
    const double ratio = 0.7 * edge / (2 * c.pair.length);
    CHECK(damping == Approx(2 * ratio * std::sqrt(stiffness * c.pair.reduced_mass)).epsilon(1e-11));
    const double volume_rate = edge * edge * speed;
    CHECK(damping * speed == Approx(c.pair.normal_damping * volume_rate).epsilon(1e-11));
}

TEST_CASE("Eq. (5.7): V̇ comes from the surface integral, spin included", "[contact]") {
    // A tilted cube's patch has its middle off the centroid: a spin changes V.
    const ContactCase c = cube_on_ground(1e-3, 0.01);
    const RelativeMotion motion{{0.3, -0.2, 0.5}, {0.4, 0.1, -0.7}};
    const double expected =
        c.geometry.area_vector.dot(motion.velocity) + c.geometry.area_moment().dot(motion.spin);
    CHECK(volume_rate(c.geometry, motion) == Approx(expected).epsilon(rounding));
    CHECK(std::abs(c.geometry.area_moment().dot(motion.spin)) > 1e-6);
}

TEST_CASE("Eq. (5.7): there is no tension, and what is cut off leaves no friction and no record",
          "[contact]") {
    ContactCase c = cube_on_ground(1e-4);
    c.remember({1, 0, 0});
    c.motion.velocity = {0.1, 0, 100};
    const ContactForce out = c.force();
    CHECK(out.state == ContactState::open);
    CHECK(out.normal_force == 0);
    CHECK(out.force == Vec3::Zero());
    CHECK(out.moment == Vec3::Zero());
    CHECK(out.trial.force == Vec3::Zero());
    // Just before the cut-off the force is still there.
    const double elastic = c.pair.elastic * c.geometry.volume;
    const double release = elastic / (c.pair.normal_damping * c.geometry.area);
    c.motion.velocity = {0, 0, 0.999 * release};
    CHECK(c.force().normal_force == Approx(1e-3 * elastic).epsilon(1e-9));
    c.motion.velocity = {0, 0, 1.001 * release};
    CHECK(c.force().normal_force == 0);
}

TEST_CASE("The damping traction resists rocking with cn ∫ r² dA, spin about n not at all", "[contact]") {
    ContactCase c;
    c.pair.friction = 0;
    const double second = 0.01 * 0.01 / 12;  // ∫ x² dA of the square face
    c.motion.spin = {0.3, -0.2, 0.9};
    const ContactForce out = c.force();
    const Vec3 expected = -c.pair.normal_damping * second * Vec3(0.3, -0.2, 0);
    CHECK(deviation(out.moment, expected, expected.norm()) < rounding);
    c.geometry.flat_patch = false;
    CHECK(c.force().moment == Vec3::Zero());
}

TEST_CASE("The traction of a real patch is the same from either body", "[contact]") {
    Random random(101);
    for (int i = 0; i < 50; ++i) {
        ContactCase c = random_case(random);
        c.pair.friction = 0;
        const ContactForce on_a = c.force();
        c.geometry = exchanged(c.geometry, Vec3::Zero());
        c.motion = {-c.motion.velocity, -c.motion.spin};
        const ContactForce on_b = c.force();
        CHECK(deviation(on_b.moment, -on_a.moment, on_a.moment.norm() + 1e-12) < 1e-10);
    }
}

TEST_CASE("A cube rocks on its face with ζ_θ = ζ ω_θ/ω_n: damping over stiffness is that of the normal",
          "[contact]") {
    // Moments about the middle of the face, for a tilt and for a spin about a horizontal axis.
    const double depth = 1e-4;
    const double tilt = 1e-5;
    ContactCase c = cube_on_ground(depth, tilt);
    c.pair.friction = 0;
    const Vec3 face_middle(0, 0, -depth);
    const ContactForce still = c.force();
    const double elastic = (c.geometry.centroid - face_middle).cross(still.force).x();
    c.motion.spin = {1, 0, 0};
    c.motion.velocity = c.motion.spin.cross(c.geometry.centroid - face_middle);
    const ContactForce rocking = c.force();
    const double damped =
        rocking.moment.x() + (c.geometry.centroid - face_middle).cross(rocking.force).x() - elastic;
    const double second = std::pow(edge, 4) / 12;
    CHECK(elastic / tilt == Approx(-c.pair.elastic * second).epsilon(1e-4));
    // The face is a thousandth of the edge deep: the side strips add depth/edge.
    CHECK(damped == Approx(-c.pair.normal_damping * second).epsilon(2e-3));
    CHECK(damped / elastic * tilt == Approx(c.pair.normal_damping / c.pair.elastic).epsilon(2e-3));
}
