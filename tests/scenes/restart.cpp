#include <cstring>

#include <catch2/catch.hpp>

#include <scree/scenes/simulation.hpp>

#include "busy_scene.hpp"

using namespace scree;
using namespace scree::test;

namespace {

using Record = std::vector<double>;

void add(const Vec3& vector, Record& record) {
    record.insert(record.end(), vector.begin(), vector.end());
}

// All that a run's tables hold of one output time.
Record record_of(const Simulation& simulation) {
    Record record;
    for (std::size_t i = 0; i < simulation.bodies().size(); ++i) {
        const FrameMotion motion = simulation.file_motion(i);
        add(motion.pose.position, record);
        record.insert(record.end(), motion.pose.orientation.coeffs().begin(),
                      motion.pose.orientation.coeffs().end());
        add(motion.velocity, record);
        add(motion.angular_velocity, record);
    }
    for (const ContactResult& result : simulation.contact_results()) {
        if (result.touching) {
            add(result.law.force, record);
            add(result.point, record);
            record.insert(record.end(), {result.volume, result.depth, result.slip_speed});
        }
    }
    const EnergyLedger& energy = simulation.report().energy;
    record.insert(record.end(), {energy.kinetic, energy.gravity, energy.normal_elastic, energy.lost_friction,
                                 energy.work_applied, energy.residual});
    return record;
}

bool same_bytes(const Record& a, const Record& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void check_cut_run(const SceneDescription& scene) {
    Simulation whole(scene);
    SavedState state = whole.save();
    while (whole.tick() < whole.times().last()) {
        Simulation part(scene);
        part.restore(state);
        REQUIRE(whole.advance());
        REQUIRE(part.advance());
        CAPTURE(whole.time());
        REQUIRE(same_bytes(record_of(whole), record_of(part)));
        REQUIRE(whole.report().steps.accepted == part.report().steps.accepted);
        REQUIRE(whole.report().all_steps.contact_evaluations >= 1);
        state = part.save();
    }
}

}  // namespace

TEST_CASE("A run that is cut at every output time gives the same bytes as a whole one", "[scenes]") {
    const std::string setting = GENERATE(
        as<std::string>(), "end_time=0.3", "stepping.max_order=5", "stepping.step=5e-4",
        "stepping.solver=fixed_point", "law.normal=manifold",
        "law={\"damping\":\"centroid\",\"reduced_mass\":\"exact\"}",
        "stepping={\"method\":\"verlet\",\"step\":2e-5}",
        "stepping={\"method\":\"symplectic_euler\",\"step\":2e-5}", "stepping={\"method\":\"bullet\"}",
        "stepping={\"method\":\"bullet\",\"step\":0.003,\"iterations\":3}");
    const bool explicit_method = setting.find("e-5") != std::string::npos;
    CAPTURE(setting);
    check_cut_run(busy_scene_with({setting, explicit_method ? "end_time=0.06" : "end_time=0.3"}));
}

TEST_CASE("What sleeps at the cut sleeps on, and is woken alike", "[scenes]") {
    const SceneDescription scene = busy_scene_with(
        {"stepping.sleep=true", "stepping.rtol=1e-3", "bodies.6.position=[2.45,0,0.05]",
         "bodies.6.velocity=[-1,0,0]", "bodies.3.position=[0.6,0,0.05]", "fill.0.count=1", "end_time=0.6"});
    check_cut_run(scene);
}

TEST_CASE("A cut run may go on with another number of threads", "[scenes]") {
    const SceneDescription scene = busy_scene_with({"end_time=0.1"});
    Simulation whole(scene);
    Simulation part(scene);
    part.set_threads(2);
    CHECK(part.threads() == 2);
    REQUIRE(part.advance());
    Simulation rest(scene);
    rest.restore(part.save());
    rest.set_threads(3);
    REQUIRE(whole.advance());
    while (whole.tick() < whole.times().last()) {
        REQUIRE(whole.advance());
        REQUIRE(rest.advance());
        REQUIRE(same_bytes(record_of(whole), record_of(rest)));
    }
}

TEST_CASE("A state of another scene is refused", "[scenes]") {
    Simulation simulation(busy_scene_with({}));
    REQUIRE(simulation.advance());
    const SavedState state = simulation.save();
    Simulation other(busy_scene_with({"fill.0.count=5"}));
    CHECK_THROWS_AS(other.restore(state), StateError);
    Simulation by_bullet(busy_scene_with({"stepping={\"method\":\"bullet\"}"}));
    CHECK_THROWS_AS(by_bullet.restore(state), StateError);
    SavedState longer = state;
    longer.numbers.push_back(0);
    Simulation same(busy_scene_with({}));
    CHECK_THROWS_AS(same.restore(longer), StateError);
    for (std::size_t count : {std::size_t{0}, std::size_t{7}, state.counts.size() - 1}) {
        SavedState shorter = state;
        shorter.counts.resize(count);
        Simulation again(busy_scene_with({}));
        CHECK_THROWS_AS(again.restore(shorter), StateError);
    }
}
