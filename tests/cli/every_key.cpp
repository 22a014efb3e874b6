#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "child.hpp"

using namespace scree::test;
using nlohmann::json;

namespace {

const std::string scene_file = SCREE_SOURCE_DIR "/tests/cli/every_key.json";

// The names of all members of all objects in it; of a schema, those that its objects may have.
void collect_keys(const json& value, bool of_schema, std::set<std::string>& keys) {
    for (const auto& [name, inner] : value.items()) {
        if (!of_schema && value.is_object()) {
            keys.insert(name);
        }
        if (of_schema && name == "properties") {
            for (const auto& [property, rules] : inner.items()) {
                keys.insert(property);
            }
        }
        if (inner.is_structured()) {
            collect_keys(inner, of_schema, keys);
        }
    }
}

void check_run(const std::vector<std::string>& settings) {
    const Folder folder;
    std::vector<std::string> words{"run", scene_file, "--quiet", "--out", folder / "out"};
    for (const std::string& setting : settings) {
        words.insert(words.end(), {"--set", setting});
    }
    const Child child(folder, words);
    CHECK(child.wait() == 0);
    CHECK(child.errors().empty());
    const json summary = json::parse(text_of(folder / "out/summary.json"));
    CHECK(summary.at("status") == "done");
    CHECK(summary.at("reached") == 0.25);
    for (const char* file : {"bodies.csv", "energy.csv", "contacts.csv", "replay.glb"}) {
        CAPTURE(file);
        CHECK(std::filesystem::file_size((folder / "out") + "/" + file) > 100);
    }
}

}  // namespace

TEST_CASE("One scene with every key runs, by every method", "[cli]") {
    const std::set<std::string> only_for_bullet{"iterations", "separating_axis", "friction_directions"};
    std::set<std::string> allowed;
    collect_keys(json::parse(text_of(SCREE_SOURCE_DIR "/src/scenes/scene.schema.json")), true, allowed);
    std::set<std::string> used;
    collect_keys(json::parse(text_of(scene_file), nullptr, true, true), false, used);
    for (const std::string& key : allowed) {
        CAPTURE(key);
        CHECK(used.contains(key) != only_for_bullet.contains(key));
    }
    check_run({});
    check_run({R"(stepping={"method":"verlet","step":2e-5})"});
    check_run({R"(stepping={"method":"bullet","step":0.002,"iterations":20,"separating_axis":true,)"
               R"("friction_directions":2})"});
}
