#include <cmath>

#include <catch2/catch.hpp>

#include <scree/contact/material.hpp>

using namespace scree;

namespace {

constexpr double rounding = 1e-14;  // a handful of operations

Material stone() {
    return {2600, 3e9, 0.6, 0.4, 0.2, 0.25, true};
}
Material steel() {
    return {7800, 2e11, 0.3, 0.1, 0.1, 0.4, true};
}

}  // namespace

TEST_CASE("Eq. (5.3): Lc of two equal spheres is the distance of their centres, else 4 r₁ r₂/(r₁ + r₂)",
          "[contact]") {
    CHECK(characteristic_length({1, 0.05}, {1, 0.05}) == Approx(0.1).epsilon(rounding));
    CHECK(characteristic_length({1, 0.1}, {5, 0.3}) == Approx(0.3).epsilon(rounding));
    CHECK(characteristic_length({1, 0.1}, {5, 0.3}) == characteristic_length({5, 0.3}, {1, 0.1}));
}

TEST_CASE("Eq. (5.3): a body that forces do not move takes the other's radius", "[contact]") {
    CHECK(characteristic_length({1, 0.05}, {}) == Approx(0.1).epsilon(rounding));
    CHECK(characteristic_length({}, {1, 0.05}) == Approx(0.1).epsilon(rounding));
    BodySize prescribed;
    prescribed.radius = 70;  // not asked for
    CHECK(characteristic_length({1, 0.05}, prescribed) == Approx(0.1).epsilon(rounding));
}

TEST_CASE("Eq. (5.28): the reduced mass is 1/(1/m₁ + 1/m₂), with 1/∞ = 0", "[contact]") {
    CHECK(reduced_mass({2, 0.1}, {3, 0.1}) == Approx(1.2).epsilon(rounding));
    CHECK(reduced_mass({2, 0.1}, {}) == 2);
    CHECK(reduced_mass({}, {3, 0.1}) == 3);
}

TEST_CASE("Eqs. (5.7), (5.17), (5.21): the constants of a pair have their closed forms", "[contact]") {
    const PairMaterial material{5e9, 0.4, 0.3, 0.2, 0.25, true};
    const PairConstants pair = pair_constants(material, {2, 0.1}, {3, 0.3});
    CHECK(pair.length == Approx(0.3).epsilon(rounding));
    CHECK(pair.reduced_mass == Approx(1.2).epsilon(rounding));
    CHECK(pair.elastic == Approx(5e9 / 0.3).epsilon(rounding));
    CHECK(pair.normal_damping == Approx(0.3 * std::sqrt(5e9 * 1.2 / std::pow(0.3, 3))).epsilon(rounding));
    CHECK(pair.tangential_stiffness == Approx(0.25 * 5e9 * 0.3).epsilon(rounding));
    CHECK(pair.tangential_damping == Approx(0.2 * std::sqrt(0.25 * 5e9 * 1.2 * 0.3)).epsilon(rounding));
    CHECK(pair.friction == 0.4);
    CHECK(pair.torsion);
}

TEST_CASE("Eq. (5.17): Yt is 2/7 of Y by default", "[contact]") {
    CHECK(Material{}.tangential_ratio == 2.0 / 7);
    CHECK(PairMaterial{}.tangential_ratio == 2.0 / 7);
}

TEST_CASE("Mixing: harmonic mean of Y, the smaller μ, means of dampings and ratios, torsion if both have it",
          "[contact]") {
    const PairMaterial pair = mix(stone(), steel());
    CHECK(pair.youngs_modulus == Approx(2 * 3e9 * 2e11 / (3e9 + 2e11)).epsilon(rounding));
    CHECK(pair.friction == 0.3);
    CHECK(pair.normal_damping == Approx(0.25).epsilon(rounding));
    CHECK(pair.tangential_damping == Approx(0.15).epsilon(rounding));
    CHECK(pair.tangential_ratio == Approx(0.325).epsilon(rounding));
    CHECK(pair.torsion);
    Material smooth = steel();
    smooth.torsion = false;
    CHECK_FALSE(mix(stone(), smooth).torsion);
    CHECK_FALSE(mix(smooth, stone()).torsion);
}

TEST_CASE("Mixing a material with itself gives it back, and the order does not matter", "[contact]") {
    const PairMaterial same = mix(stone(), stone());
    CHECK(same.youngs_modulus == Approx(3e9).epsilon(rounding));
    CHECK(same.friction == 0.6);
    CHECK(same.normal_damping == 0.4);
    CHECK(same.tangential_damping == 0.2);
    CHECK(same.tangential_ratio == 0.25);
    const PairMaterial forth = mix(stone(), steel());
    const PairMaterial back = mix(steel(), stone());
    CHECK(forth.youngs_modulus == back.youngs_modulus);
    CHECK(forth.friction == back.friction);
    CHECK(forth.normal_damping == back.normal_damping);
    CHECK(forth.tangential_damping == back.tangential_damping);
}
