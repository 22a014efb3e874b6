#include <catch2/catch.hpp>

#include <scree/scenes/features.hpp>

#include "small_scene.hpp"

using namespace scree;
using namespace scree::test;

namespace {

bool uses(const char* feature, const std::vector<std::string>& settings) {
    return scene_features(small_scene_with(settings)).uses(feature);
}

}  // namespace

TEST_CASE("A scene uses what it enters, and leaves out the rest", "[scenes]") {
    const Features features = scene_features(small_scene_with({}));
    for (const char* used : {"gravity", "friction", "torsion", "normal_damping", "tangential_damping",
                             "boxes", "spheres", "half_spaces", "fixed_bodies", "newton", "error_control"}) {
        CAPTURE(used);
        CHECK(features.uses(used));
    }
    for (const char* left_out :
         {"meshes", "decomposition", "prescribed_motion", "fill", "pairs", "bullet_manifolds"}) {
        CAPTURE(left_out);
        CHECK_FALSE(features.uses(left_out));
    }
    CHECK(features.used.size() + features.left_out.size() == 38);
}

TEST_CASE("Friction and what hangs on it are left out together", "[scenes]") {
    for (const char* setting : {"law.friction=none", "materials.rock.friction=0"}) {
        CAPTURE(setting);
        for (const char* part : {"friction", "torsion", "tangential_damping", "co_rotation"}) {
            CHECK_FALSE(uses(part, {setting}));
        }
    }
    CHECK(uses("friction",
               {"materials.rock.friction=0", R"(pairs=[{"materials": ["rock", "rock"], "friction": 0.1}])"}));
}

TEST_CASE("Torsion needs a material that has it and a shape that can show it", "[scenes]") {
    CHECK_FALSE(uses("torsion", {"materials.rock.torsion=false"}));
    CHECK_FALSE(uses("torsion", {"bodies.1.shape=ball"}));
    CHECK(uses("torsion", {"materials.rock.torsion=false",
                           R"(pairs=[{"materials": ["rock", "rock"], "torsion": true}])"}));
}

TEST_CASE("The law's choices are used where there is something for them to do", "[scenes]") {
    const std::pair<const char*, const char*> choices[] = {
        {"law.friction=cundall_strack_2d", "plane_friction"},  {"law.friction=viscous", "viscous_friction"},
        {"law.tangential_stiffness=patch", "patch_stiffness"}, {"law.reduced_mass=exact", "effective_mass"},
        {"law.reduced_mass=round", "effective_mass"},
    };
    for (const auto& [setting, feature] : choices) {
        CAPTURE(setting);
        CHECK_FALSE(uses(feature, {}));
        CHECK(uses(feature, {setting}));
        CHECK_FALSE(uses(feature, {setting, "materials.rock.friction=0"}));
    }
    CHECK(uses("rocking_damping", {}));
    CHECK_FALSE(uses("rocking_damping", {"law.damping=centroid"}));
    CHECK_FALSE(uses("rocking_damping", {"materials.rock.normal_damping=0"}));
    CHECK_FALSE(uses("damping_by_patch", {}));
    CHECK(uses("damping_by_patch", {"law.normal_damping=patch"}));
    CHECK_FALSE(uses("damping_by_patch", {"law.normal_damping=patch", "materials.rock.normal_damping=0"}));
    CHECK_FALSE(uses("effective_mass", {"law.reduced_mass=exact", "materials.rock.tangential_damping=0"}));
    for (const char* friction : {"law.friction=cundall_strack_2d", "law.friction=viscous"}) {
        CHECK_FALSE(uses("co_rotation", {friction}));
    }
    CHECK_FALSE(uses("torsion", {"law.friction=cundall_strack_2d"}));
    CHECK(uses("torsion", {"law.friction=viscous"}));
}

TEST_CASE("Rolling friction and cohesion are used where a material or a pair has them", "[scenes]") {
    for (const std::string key : {"rolling_friction", "cohesion"}) {
        CAPTURE(key);
        CHECK_FALSE(uses(key.c_str(), {}));
        CHECK_FALSE(uses(key.c_str(), {"materials.rock." + key + "=0"}));
        CHECK(uses(key.c_str(), {"materials.rock." + key + "=0.1"}));
        CHECK(uses(key.c_str(), {R"(pairs=[{"materials": ["rock", "rock"], ")" + key + R"(": 0.1}])"}));
        CHECK_FALSE(uses(key.c_str(), {"materials.rock." + key + "=0.1", "stepping.method=bullet"}));
    }
}

TEST_CASE("Kinetic friction is used where a material or a pair names it", "[scenes]") {
    CHECK_FALSE(uses("kinetic_friction", {}));
    CHECK(uses("kinetic_friction", {"materials.rock.kinetic_friction=0.4"}));
    CHECK(uses("kinetic_friction", {R"(pairs=[{"materials": ["rock", "rock"], "kinetic_friction": 0.1}])"}));
    CHECK_FALSE(uses("kinetic_friction", {"law.friction=none", "materials.rock.kinetic_friction=0.4"}));
}

TEST_CASE("A fixed step leaves the error control out", "[scenes]") {
    CHECK_FALSE(uses("error_control", {"stepping.step=1e-4"}));
}

TEST_CASE("What is not written is left out", "[scenes]") {
    CHECK(uses("replay", {}));
    CHECK_FALSE(uses("replay", {"output.replay=false"}));
    CHECK_FALSE(uses("checkpoints", {}));
    CHECK(uses("checkpoints", {"output.checkpoint_every=1"}));
}
