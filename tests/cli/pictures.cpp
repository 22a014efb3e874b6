// What others make of a replay: a browser that plays the page, and f3d that takes a picture.

#include <algorithm>
#include <cstdlib>

#include <catch2/catch.hpp>

#include <tests/scenes/busy_scene.hpp>
#include <tests/support/glb.hpp>

#include "child.hpp"

using namespace scree::test;

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// The busy scene, run.
struct Run {
    Folder folder;
    std::string out = folder / "out";

    explicit Run(const Words& settings = {}) {
        Words words = {"run", folder.write("busy.json", busy_scene), "--out", out, "--quiet"};
        for (const std::string& setting : settings) {
            words.insert(words.end(), {"--set", setting});
        }
        REQUIRE(Child(folder, words).wait() == 0);
    }
    void scree(Words words) const {
        words.emplace_back("--quiet");
        const Child child(folder, words);
        const int status = child.wait();
        CAPTURE(words, child.errors());
        REQUIRE(status == 0);
    }
};

/// What a headless browser makes of a page, given options.
std::string browse(const Run& run, const std::string& page, const Words& options) {
    Words words = {"/usr/bin/env",
                   "chromium",
                   "--headless",
                   "--no-sandbox",
                   "--use-angle=swiftshader",
                   "--enable-unsafe-swiftshader",
                   "--window-size=900,600",
                   "--virtual-time-budget=3000"};
    words.insert(words.end(), options.begin(), options.end());
    words.push_back("file://" + page);
    const Child child(run.folder, words, Child::Words::whole);
    REQUIRE(child.wait() == 0);
    return child.output();
}

std::string attribute(const std::string& page, const std::string& name) {
    const std::string start = "data-" + name + "=\"";
    const std::size_t at = page.find(start);
    return at == std::string::npos
               ? ""
               : page.substr(at + start.size(), page.find('"', at + start.size()) - at - start.size());
}

}  // namespace

TEST_CASE("A page holds the replay, the energy and all that it needs", "[cli]") {
    if (!fs::exists("/usr/share/javascript/three/three.min.js")) {
        WARN("three.js is not installed");
        return;
    }
    const Run run({"bodies.0.name=\"</script> & <b>\""});
    run.scree({"page", run.out});
    const std::string page = text_of(run.out + "/page.html");
    CHECK_THAT(page, Catch::Contains("<title>busy</title>") && Catch::Contains("\"kinetic\"") &&
                         Catch::Contains("THREE.GLTFLoader") && !Catch::Contains("</script> &") &&
                         !Catch::Contains("@data@"));
}

TEST_CASE("A still of any moment is a glTF file", "[cli]") {
    const Run run;
    const std::string still = run.folder / "still.glb";
    run.scree({"picture", run.out, "--at", "0.13", "--out", still});
    check_glb(Glb(text_of(still)));
    check_glb(Glb(text_of(run.out + "/replay.glb")));
}

TEST_CASE("Pages and pictures of what is no run are refused by one line", "[cli]") {
    const Folder folder;
    for (const char* command : {"page", "picture"}) {
        const Child child(folder, {command, folder.path().string()});
        CHECK(child.wait() == 4);
        const std::string errors = child.errors();
        CHECK_THAT(errors, Catch::Contains("found no") && Catch::Contains("expected"));
        CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
    }
}

TEST_CASE("A browser plays the page", "[.long]") {
    const Run run;
    const std::string page = run.out + "/page.html";
    run.scree({"page", run.out});
    const std::string played = browse(run, page, {"--dump-dom"});
    CHECK(attribute(played, "error").empty());
    CHECK(attribute(played, "bodies") == "13");
    CHECK(std::atoi(attribute(played, "frames").c_str()) > 1);

    const std::string begin = run.folder / "begin.png";
    const std::string end = run.folder / "end.png";
    browse(run, page + "#0", {"--screenshot=" + begin});
    browse(run, page + "#0.3", {"--screenshot=" + end});
    CHECK(fs::file_size(begin) > 10000);
    CHECK(text_of(begin) != text_of(end));
}

TEST_CASE("f3d takes a picture of a moment", "[.long]") {
    const Run run;
    run.scree({"picture", run.out, "--at", "0.1"});
    CHECK(fs::file_size(run.out + "/picture.png") > 5000);
    CHECK_FALSE(fs::exists(run.out + "/picture.png.glb"));
}
