// What the equations of a pile of mesh particles cost: stiff, with friction, and at all times some contact
// opens or closes.

#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

// 64 icosahedra of 5 cm fall into a box of half a metre.
Simulation pile() {
    const std::string mesh = std::string(SCREE_SOURCE_DIR) + "/meshes/icosahedron.obj";
    return Simulation(parse_scene(R"({
        "materials": {"rock": {"density": 2600, "youngs_modulus": 1e10, "friction": 0.5}},
        "shapes": {
            "floor": {"half_space": {"normal": [0, 0, 1]}},
            "left": {"half_space": {"normal": [1, 0, 0], "offset": -0.25}},
            "right": {"half_space": {"normal": [-1, 0, 0], "offset": -0.25}},
            "front": {"half_space": {"normal": [0, 1, 0], "offset": -0.25}},
            "back": {"half_space": {"normal": [0, -1, 0], "offset": -0.25}},
            "stone": {"mesh": ")" + mesh +
                                      R"(", "scale": 0.05}
        },
        "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
                   {"shape": "left", "material": "rock", "motion": "fixed"},
                   {"shape": "right", "material": "rock", "motion": "fixed"},
                   {"shape": "front", "material": "rock", "motion": "fixed"},
                   {"shape": "back", "material": "rock", "motion": "fixed"}],
        "fill": [{"shape": "stone", "material": "rock", "count": 64, "box": [[-0.25, -0.25, 0], [0.25, 0.25, 0.6]]}],
        "stepping": {"rtol": 1e-3}, "end_time": 1, "output": {"every": 0.02}
    })",
                                  "pile"));
}

}  // namespace

TEST_CASE("A falling and settling pile of 64 icosahedra takes fewer than 5 iterations a step and repeats few",
          "[.long][long]") {
    Simulation simulation = pile();
    while (simulation.tick() < simulation.times().last()) {
        REQUIRE(simulation.advance());
    }
    const StepReport& report = simulation.world().step_report();
    const SteppingStatistics& steps = report.steps;
    CAPTURE(steps.accepted, steps.rejected_error, steps.rejected_newton, steps.newton.iterations);
    CHECK(steps.newton.iterations < 5 * steps.accepted);
    CHECK(10 * (steps.rejected_error + steps.rejected_newton) < steps.accepted);
    const EnergyLedger& energy = report.energy;
    CHECK(std::abs(energy.residual) < 0.02 * (energy.lost() + energy.kinetic));
    CHECK(report.contacts > 64);
}
