// The scenes that come with scree give what literature and closed forms say of them; demos/gallery measures.

#include <catch2/catch.hpp>

#include <demos/gallery/scenes.hpp>

using namespace scree;
using namespace scree::gallery;

namespace {

void check(const Rows& rows) {
    CHECK_FALSE(rows.empty());
    for (const Row& row : rows) {
        CAPTURE(row.scene, row.what, row.measured, row.low, row.high, row.source);
        CHECK(row.holds());
    }
}

}  // namespace

TEST_CASE("The block on its slope accelerates by g (sin θ − μ cos θ)") {
    check(incline_rows());
}

TEST_CASE(
    "The arch stands above t/R = 0.1075 and falls below, of all but rigid stones within half a thousandth") {
    check(arch_rows());
}

TEST_CASE("The tower of soft cubes stands above its buckling limit and falls below") {
    check(tower_rows());
}

TEST_CASE("The conveyor's stones lag by u²/(2μg), for a work of m u²") {
    check(conveyor_rows());
}

TEST_CASE("A block on the vibrating plate flies as the one that does not bounce", "[.long]") {
    check(vibrating_plate_rows());
}

TEST_CASE("The wall stands, is hit and keeps momentum and energy", "[.long]") {
    check(wall_rows());
}

TEST_CASE("The drum's work is the moment of what it lifts, times its turn", "[.long]") {
    check(drum_rows());
}

TEST_CASE("The heap behind the gate is the steeper the rougher its stones are", "[.long]") {
    check(repose_rows());
}

TEST_CASE("The hopper runs out at Beverloo's rate", "[.long]") {
    check(hopper_rows());
}

TEST_CASE("Each of the Platonic solids packs between loose and dense", "[.long]") {
    check(packing_rows());
}

TEST_CASE("The pile comes to rest", "[.long]") {
    check(pile_rows());
}
