#include <unistd.h>

#include <cmath>
#include <fstream>

#include <catch2/catch.hpp>

#include <scree/scenes/simulation.hpp>

#include <tests/scenes/busy_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// [bytes], of this process at present.
double resident_memory() {
    double whole = 0;
    double resident = 0;
    std::ifstream("/proc/self/statm") >> whole >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// All that the ledger has seen flow.
double flowed(const EnergyLedger& energy) {
    return std::abs(energy.work_applied) + std::abs(energy.lost_friction) +
           std::abs(energy.lost_normal_damping) + std::abs(energy.lost_tangential_damping);
}

}  // namespace

// Friction and damping take what the belt and the shaker put in, for ever; the residual is the error of the
// time stepping, a share of what flows, and must not outgrow it.
TEST_CASE("A million steps let neither memory nor the ledger's residual grow", "[.long]") {
    Simulation simulation(busy_scene_with({"output.every=2e-4", "end_time=200", "fill.0.count=1",
                                           "bodies.6.velocity=[0,0,0]", "stepping.rtol=1e-3"}));
    constexpr std::int64_t ticks = 1'000'000;
    double early_memory = 0;
    double early_share = 0;
    while (simulation.tick() < ticks) {
        REQUIRE(simulation.advance());
        if (simulation.tick() == ticks / 10) {
            early_memory = resident_memory();
            early_share = std::abs(simulation.report().energy.residual) / flowed(simulation.report().energy);
        }
    }
    const EnergyLedger& energy = simulation.report().energy;
    INFO("steps " << simulation.report().steps.accepted << ", residual " << energy.residual << " J of "
                  << flowed(energy) << " J, was " << early_share << " of it");
    CHECK(simulation.report().steps.accepted >= 1'000'000);
    CHECK(resident_memory() - early_memory < 1 << 20);
    CHECK(std::abs(energy.residual) < 1e-2 * flowed(energy));
    CHECK(std::abs(energy.residual) / flowed(energy) < 2 * early_share + 1e-3);
}
