#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include <tests/support/bad_scenes.hpp>
#include <tests/support/mesh_files.hpp>

#include "small_scene.hpp"

using namespace scree;
using namespace scree::test;

namespace {

/// The one line that refuses a scene; empty when it is accepted.
std::string refusal(const std::string& text, const std::vector<std::string>& settings = {}) {
    try {
        parse_scene(text, "small.json", settings);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

void check_refused(const std::string& message, const std::string& expected) {
    CHECK_THAT(message, Catch::Contains(expected));
    CHECK(std::count(message.begin(), message.end(), '\n') == 0);
    CHECK(message.size() < 300);
}

}  // namespace

TEST_CASE("Text that is no scene is refused by file and line or key", "[scenes]") {
    for (const BadScene& bad : bad_texts()) {
        CAPTURE(bad.text);
        check_refused(refusal(bad.text), bad.message);
    }
}

TEST_CASE("A bad value is refused by file and key, with what was found and expected", "[scenes]") {
    CHECK(bad_texts().size() + bad_values().size() > 150);
    for (const BadScene& bad : bad_values()) {
        CAPTURE(bad.setting);
        const std::string message = refusal(bad.text, {bad.setting});
        check_refused(message, bad.message);
        CHECK(message.substr(0, 5) == (bad.message.substr(0, 5) == "--set" ? "--set" : "small"));
        CHECK_THAT(message, Catch::Contains("found ") && Catch::Contains(", expected "));
    }
}

TEST_CASE("What this build cannot do is refused, and not when it is switched off", "[scenes]") {
    for (const BadScene& absent : absent_values()) {
        CAPTURE(absent.setting);
        check_refused(refusal(absent.text, {absent.setting}), absent.message);
    }
    const std::vector<std::string> off = {"output.vtk=false", "output.replay=false",
                                          "output.checkpoint_every=0"};
    CHECK(refusal(small_scene, off).empty());
}

TEST_CASE("Hostile text is refused without harm", "[scenes]") {
    const std::string deep(1'000'000, '[');
    check_refused(refusal(deep), "nested 17 deep");
    std::string long_key = "{\"\": 1}";
    long_key.insert(2, 1'000'000, 'k');
    check_refused(refusal(long_key), "found an unknown key");
    std::string long_string = "{\"gravity\": \"\"}";
    long_string.insert(13, 1'000'000, 's');
    check_refused(refusal(long_string), "…, expected a list of 3 numbers");
}

TEST_CASE("A scene file is read up to a size that no scene needs, and a folder is none", "[scenes]") {
    const MeshFiles files;
    const std::filesystem::path file = files.text("large.json", small_scene);
    const auto refusal_of = [](const std::filesystem::path& path) -> std::string {
        try {
            read_scene(path);
        } catch (const SceneError& error) {
            return error.what();
        }
        return "";
    };
    CHECK(refusal_of(file).empty());
    std::filesystem::resize_file(file, 40 << 20);  // sparse: takes no room
    check_refused(refusal_of(file), "large.json: found more than 32 MiB, expected a scene");
    check_refused(refusal_of(files.folder()), "found no file that can be read, expected a scene");
    check_refused(refusal_of("/dev/zero"), "found more than 32 MiB, expected a scene");
}
