// The schema for editors and the parser agree, but for what no schema can say.

#include <algorithm>
#include <fstream>
#include <optional>

#include <catch2/catch.hpp>

#include <scree/scenes/find_scene.hpp>

#include <src/scenes/json_text.hpp>
#include <tests/support/bad_scenes.hpp>
#include <tests/support/json_schema.hpp>

#include "busy_scene.hpp"
#include "small_scene.hpp"

using namespace scree;
using namespace scree::test;
using nlohmann::json;

namespace {

json file_json(const std::string& file) {
    std::ifstream stream(std::string(SCREE_SOURCE_DIR "/") + file);
    return json::parse(stream);
}

const JsonSchema& schema() {
    static const JsonSchema known(file_json("src/scenes/scene.schema.json"));
    return known;
}

/// Why a parser refuses what a schema cannot: names, sizes of sums, one number against another, the files
/// there are.
constexpr const char* beyond_schemas[] = {
    "expected the name of a",
    "\"ice\", expected the name",
    " again,",
    "a half-space",
    "found more than",
    "at most the friction",
    "the pair's friction",
    "fixed body that",
    "of its own",
    "the lowest corner, ",
    "the smaller number",
    "1000000 at most",
    "expected 16 at most",
};

bool beyond(const std::string& message) {
    return std::any_of(std::begin(beyond_schemas), std::end(beyond_schemas),
                       [&](const char* reason) { return message.find(reason) != std::string::npos; });
}

/// A scene as JSON, with a setting; nothing when that is refused already.
std::optional<json> json_of(const BadScene& scene) {
    try {
        Json value = parse_json(scene.text, "scene");
        if (!scene.setting.empty()) {
            apply_setting(value, scene.setting);
        }
        return json::parse(value.dump());
    } catch (const SceneError&) {
        return std::nullopt;
    }
}

}  // namespace

TEST_CASE("The schema accepts what the parser accepts", "[scenes]") {
    for (const ShippedScene& shipped : shipped_scenes()) {
        CAPTURE(shipped.name);
        std::ifstream stream(shipped.file);
        CHECK(schema().accepts(json::parse(stream, nullptr, true, true)));
    }
    CHECK(schema().accepts(json::parse(busy_scene)));
    for (const char* setting :
         {"law={\"normal\":\"manifold\",\"co_rotation\":false}",
          "stepping={\"method\":\"verlet\",\"step\":1e-5}",
          "stepping={\"method\":\"bullet\",\"iterations\":5,\"friction_directions\":2}",
          "bodies.1.orientation=[0,0,0,2]", "stepping={\"step\":\"adaptive\",\"max_order\":5}",
          "output={\"checkpoint_every\":0.5,\"replay\":false}",
          "bodies.1.motion={\"velocity\":[0,0,1],\"amplitude\":1,\"frequency\":2}",
          "shapes.crate={\"box\":[1,2,3]}"}) {
        CAPTURE(setting);
        const BadScene scene{small_scene, setting, ""};
        CHECK(schema().accepts(*json_of(scene)));
        CHECK_NOTHROW(small_scene_with({setting}));
    }
}

TEST_CASE("The schema refuses what the parser refuses, but for what no schema can say", "[scenes]") {
    std::size_t judged = 0;
    for (const auto& scenes : {bad_texts(), bad_values()}) {
        for (const BadScene& bad : scenes) {
            const std::optional<json> value = json_of(bad);
            if (!value || beyond(bad.message)) {
                continue;
            }
            CAPTURE(bad.text, bad.setting, bad.message);
            CHECK_FALSE(schema().accepts(*value));
            ++judged;
        }
    }
    CHECK(judged > 100);
}

TEST_CASE("What no schema can say it does not say", "[scenes]") {
    for (const BadScene& bad : bad_values()) {
        if (const std::optional<json> value = json_of(bad); value && beyond(bad.message)) {
            CAPTURE(bad.setting, bad.message);
            CHECK(schema().accepts(*value));
        }
    }
}
