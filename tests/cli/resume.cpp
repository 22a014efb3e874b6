#include <chrono>
#include <random>
#include <thread>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <tests/scenes/busy_scene.hpp>

#include "child.hpp"

using namespace scree::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const Words tables = {"bodies.csv", "energy.csv", "contacts.csv", "replay.glb"};

Words joined(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

int run(const Folder& folder, const Words& words, const Words& more = {}) {
    return Child(folder, joined(joined(words, more), {"--quiet"})).wait();
}

void check_same(const std::string& one, const std::string& other) {
    for (const std::string& table : tables) {
        CAPTURE(table);
        CHECK(text_of(one + "/" + table) == text_of(other + "/" + table));
    }
}

/// The busy scene on disk, and what an uninterrupted run of it writes.
class Case {
  public:
    explicit Case(Words settings = {}) {
        settings.insert(settings.end(), {"output.contacts=true", "output.checkpoint_every=0.02"});
        const std::string scene = folder.write("busy.json", busy_scene);
        start = {"run", scene};
        for (const std::string& setting : settings) {
            start.insert(start.end(), {"--set", setting});
        }
        REQUIRE(run(folder, start, {"--out", whole}) == 0);
    }

    const Folder folder;
    const std::string whole = folder / "whole";
    const std::string out = folder / "out";
    Words start;
    [[nodiscard]] Words resume() const { return {"resume", out}; }
    [[nodiscard]] std::string checkpoint() const { return out + "/checkpoint.cbor"; }
};

/// Kills a run, and what goes on from it, at random moments [ms]; then lets it come to its end.
void run_killed(const Case& scene, std::mt19937& random, int longest) {
    constexpr int most_kills = 3;
    std::uniform_int_distribution<int> moment(0, longest);
    for (int kills = 0; kills <= most_kills; ++kills) {
        const bool begun = fs::exists(scene.checkpoint());
        const Words words = begun ? joined(scene.resume(), {"--quiet"})
                                  : joined(scene.start, {"--out", scene.out, "--quiet"});
        const Child child(scene.folder, words);
        if (kills < most_kills) {
            std::this_thread::sleep_for(std::chrono::milliseconds(moment(random)));
            child.send(SIGKILL);
        }
        const int status = child.wait();
        CHECK((status == 0 || (kills < most_kills && status == -SIGKILL)));
    }
}

void check_kills(int times, const Words& settings) {
    const auto begin = std::chrono::steady_clock::now();
    const Case scene(settings);
    const auto whole = std::chrono::steady_clock::now() - begin;
    const auto longest = std::chrono::duration_cast<std::chrono::milliseconds>(whole).count();
    std::mt19937 random(1);
    for (int i = 0; i < times; ++i) {
        CAPTURE(i);
        fs::remove_all(scene.out);
        run_killed(scene, random, static_cast<int>(longest));
        check_same(scene.whole, scene.out);
    }
}

}  // namespace

TEST_CASE("A run that is stopped and resumed writes the same bytes as a whole one", "[cli]") {
    const Case scene;
    REQUIRE(run(scene.folder, scene.start, {"--out", scene.out, "--until", "0.11"}) == 0);
    CHECK(text_of(scene.out + "/bodies.csv") != text_of(scene.whole + "/bodies.csv"));
    REQUIRE(run(scene.folder, scene.resume(), {"--until", "0.2"}) == 0);
    REQUIRE(run(scene.folder, scene.resume(), {"--threads", "2"}) == 0);
    check_same(scene.whole, scene.out);
    const json summary = json::parse(text_of(scene.out + "/summary.json"));
    const json expected = json::parse(text_of(scene.whole + "/summary.json"));
    CHECK(summary.at("status") == "done");
    CHECK(summary.at("threads") == 2);
    for (const char* key :
         {"steps", "orders", "newton", "energy", "bodies", "contacts", "contact_evaluations"}) {
        CAPTURE(key);
        CHECK(summary.at(key) == expected.at(key));
    }
}

TEST_CASE("Resuming a run that is done does nothing", "[cli]") {
    const Case scene;
    const auto before = fs::last_write_time(scene.whole + "/bodies.csv");
    CHECK(run(scene.folder, {"resume", scene.whole}) == 0);
    CHECK(fs::last_write_time(scene.whole + "/bodies.csv") == before);
    CHECK(fs::last_write_time(scene.whole + "/summary.json") <= fs::file_time_type::clock::now());
}

TEST_CASE("A run that was killed with rows beyond its checkpoint is cut back to it", "[cli]") {
    const Case scene;
    REQUIRE(run(scene.folder, scene.start, {"--out", scene.out, "--until", "0.1"}) == 0);
    std::ofstream(scene.out + "/bodies.csv", std::ios::app) << "0.12,ground,half a ro";
    std::ofstream(scene.out + "/contacts.csv", std::ios::app) << std::string(1 << 20, 'x');
    REQUIRE(run(scene.folder, scene.resume()) == 0);
    check_same(scene.whole, scene.out);
}

TEST_CASE("When a checkpoint is written changes nothing", "[cli]") {
    const Case scene;
    REQUIRE(run(scene.folder, scene.start, {"--out", scene.out, "--set", "output.checkpoint_every=0.07"}) ==
            0);
    check_same(scene.whole, scene.out);
    const std::string other = scene.folder / "other";
    REQUIRE(run(scene.folder, scene.start, {"--out", other, "--set", "output.checkpoint_every=0"}) == 0);
    check_same(scene.whole, other);
    CHECK_FALSE(fs::exists(other + "/checkpoint.cbor"));
    CHECK_FALSE(fs::exists(other + "/replay.poses"));
}

TEST_CASE("The number of threads changes no byte", "[cli]") {
    const Case scene;
    const std::string threads = GENERATE("2", "3", "7");
    REQUIRE(run(scene.folder, scene.start, {"--out", scene.out, "--threads", threads}) == 0);
    check_same(scene.whole, scene.out);
    CHECK(json::parse(text_of(scene.out + "/summary.json")).at("threads") == std::stoi(threads));
}

TEST_CASE("A run that is killed at any moment ends with the same bytes", "[cli]") {
    check_kills(3, {});
}

TEST_CASE("A hundred runs that are killed at random moments end with the same bytes", "[.long]") {
    check_kills(70, {"end_time=0.6"});
    check_kills(10, {"stepping={\"method\":\"bullet\"}", "end_time=2"});
    check_kills(10, {"law.normal=manifold", "end_time=0.5"});
    check_kills(10, {"stepping.sleep=true", "end_time=0.6"});
}

TEST_CASE("Ctrl-C leaves a checkpoint from which the run goes on", "[cli]") {
    const Case scene({"end_time=0.6"});
    for (int i = 0; i < 2; ++i) {
        const Words words = i == 0 ? joined(scene.start, {"--out", scene.out, "--quiet"})
                                   : joined(scene.resume(), {"--quiet"});
        const Child child(scene.folder, words);
        std::this_thread::sleep_for(std::chrono::milliseconds(80));
        child.send(SIGINT);
        if (const int status = child.wait(); status == 130) {
            CHECK(json::parse(text_of(scene.out + "/summary.json")).at("status") == "interrupted");
        } else {
            CHECK((status == 0 || status == -SIGINT));
        }
        if (!fs::exists(scene.checkpoint())) {
            return;  // it had not begun
        }
    }
    REQUIRE(run(scene.folder, scene.resume()) == 0);
    check_same(scene.whole, scene.out);
}

TEST_CASE("What is no checkpoint is refused by one line, with status 4", "[cli]") {
    const Case scene;
    REQUIRE(run(scene.folder, scene.start, {"--out", scene.out, "--until", "0.1"}) == 0);
    const std::string table = text_of(scene.out + "/bodies.csv");
    const std::string good = text_of(scene.checkpoint());
    const auto refused = [&](const std::string& message) {
        const Child child(scene.folder, scene.resume());
        CHECK(child.wait() == 4);
        const std::string errors = child.errors();
        CHECK_THAT(errors, Catch::Contains(message) && Catch::Contains("expected"));
        CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
        CHECK(text_of(scene.out + "/bodies.csv") == table);
    };
    const auto write = [&](const std::string& bytes) { std::ofstream(scene.checkpoint()) << bytes; };
    write(good.substr(0, good.size() / 2));
    refused("checkpoint.cbor: found");
    std::string altered = good;
    altered[good.size() / 2] ^= 1;
    write(altered);
    refused("it has been altered");
    write("");
    refused("found another file");
    fs::remove(scene.checkpoint());
    refused("found no checkpoint");
    const Child child(scene.folder, {"resume", scene.folder / "nowhere"});
    CHECK(child.wait() == 4);
    CHECK_THAT(child.errors(), Catch::Contains("nowhere: found no such folder"));
}

TEST_CASE("A table that has lost rows is refused", "[cli]") {
    const Case scene;
    REQUIRE(run(scene.folder, scene.start, {"--out", scene.out, "--until", "0.1"}) == 0);
    fs::resize_file(scene.out + "/energy.csv", 20);
    const Child child(scene.folder, scene.resume());
    CHECK(child.wait() == 4);
    CHECK_THAT(child.errors(), Catch::Contains("energy.csv: found 20 bytes, expected at least "));
}

TEST_CASE("A mesh that has changed since is refused with status 2", "[cli]") {
    const Folder folder;
    const std::string mesh = folder / "stone.obj";
    fs::copy_file(SCREE_SOURCE_DIR "/meshes/stone_a.obj", mesh);
    const std::string scene = folder.write("busy.json", busy_scene);
    const std::string out = folder / "out";
    const Words words = {"run",   scene, "--set",   "shapes.stone={\"mesh\":\"stone.obj\",\"scale\":0.08}",
                         "--out", out,   "--until", "0.1"};
    REQUIRE(run(folder, words) == 0);
    REQUIRE(run(folder, {"resume", out, "--until", "0.12"}) == 0);
    fs::copy_file(SCREE_SOURCE_DIR "/meshes/stone_b.obj", mesh, fs::copy_options::overwrite_existing);
    const Child child(folder, {"resume", out});
    CHECK(child.wait() == 2);
    CHECK_THAT(child.errors(), Catch::Contains("shapes.stone: found another geometry"));
}

TEST_CASE("Where no more can be written the run ends with status 4, and goes on once there is room",
          "[cli]") {
    const Case scene({"end_time=0.6"});
    constexpr const char* limited = "ulimit -f \"$1\"; shift; exec \"$@\"";
    Words words = {"/bin/bash", "-c", limited, "limited", "40", Child::program()};
    words.insert(words.end(), scene.start.begin(), scene.start.end());
    words.insert(words.end(), {"--out", scene.out, "--quiet"});
    const Child child(scene.folder, words, Child::Words::whole);
    CHECK(child.wait() == 4);
    const std::string errors = child.errors();
    CHECK_THAT(errors, Catch::Contains("bodies.csv: found File too large, expected to write it"));
    CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
    REQUIRE(run(scene.folder, scene.resume()) == 0);
    check_same(scene.whole, scene.out);
}
