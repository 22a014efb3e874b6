#include <algorithm>
#include <chrono>
#include <thread>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <tests/scenes/small_scene.hpp>
#include <tests/support/bad_meshes.hpp>
#include <tests/support/bad_scenes.hpp>

#include "child.hpp"

using namespace scree::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

const std::string cube_file = SCREE_SOURCE_DIR "/meshes/cube.obj";

/// Runs the program to its end and checks how it ends.
std::string errors_of(const Folder& folder, const std::vector<std::string>& words, int status) {
    CAPTURE(words);
    const Child child(folder, words);
    CHECK(child.wait() == status);
    return child.errors();
}

void check_refused(const Folder& folder, const std::vector<std::string>& words, const std::string& message) {
    const std::string errors = errors_of(folder, words, 2);
    CAPTURE(words);
    CHECK_THAT(errors, Catch::Contains(message));
    CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
}

json summary_in(const std::string& folder) {
    return json::parse(text_of(folder + "/summary.json"));
}

}  // namespace

TEST_CASE("A run writes its tables, its summary and exits 0", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    CHECK(errors_of(folder, {"run", scene, "--out", folder / "out", "--quiet"}, 0).empty());
    const json summary = summary_in(folder / "out");
    CHECK(summary.at("status") == "done");
    CHECK(summary.at("scene") == "small");
    CHECK(summary.at("reached") == 0.1);
    CHECK(summary.at("bodies").size() == 3);
    CHECK(summary.at("bodies")[2].at("name") == "ball.0");
    const std::string table = text_of(folder / "out/bodies.csv");
    CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 3 * 6);
    CHECK_THAT(table, Catch::Contains("\n0,block,0,0,0.05,1,0,0,0,0,0,0,0,0,0\n"));
    CHECK_THAT(table, Catch::Contains("\n0.1,block,"));
}

TEST_CASE("Energy and contacts are written at every output time", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    errors_of(folder, {"run", scene, "--out", folder / "out", "--quiet", "--set", "output.contacts=true"}, 0);
    const std::string energy = text_of(folder / "out/energy.csv");
    CHECK(std::count(energy.begin(), energy.end(), '\n') == 1 + 5);
    CHECK_THAT(energy, Catch::StartsWith("t,kinetic,gravity,normal_elastic,tangential_elastic,"));
    const std::string contacts = text_of(folder / "out/contacts.csv");
    CHECK_THAT(contacts,
               Catch::StartsWith("t,a,b,px,py,pz,nx,ny,nz,volume,area,depth,fn,ftx,fty,ftz,slip\n"));
    CHECK_THAT(contacts, Catch::Contains("\n0.1,ground,block,"));
}

TEST_CASE("The explicit methods run the same scene", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    for (const std::string method : {"verlet", "symplectic_euler"}) {
        const std::string setting = "stepping={\"method\":\"" + method + "\",\"step\":2e-5}";
        errors_of(folder, {"run", scene, "--out", folder / method, "--quiet", "--set", setting}, 0);
        CHECK(summary_in(folder / method).at("steps").at("accepted").get<int>() >= 5000);
    }
}

TEST_CASE("Bullet's own solver runs the same scene, with the same files", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    errors_of(folder, {"run", scene, "--out", folder / "scree", "--quiet"}, 0);
    errors_of(folder,
              {"run", scene, "--out", folder / "bullet", "--quiet", "--set", "stepping.method=bullet",
               "--set", "output.contacts=true"},
              0);
    const json own = summary_in(folder / "scree");
    const json other = summary_in(folder / "bullet");
    for (const auto& [key, value] : own.items()) {
        CAPTURE(key);
        CHECK(other.contains(key));
    }
    CHECK(other.at("reached") == 0.1);
    CHECK(other.at("energy").size() == own.at("energy").size());
    const auto rows = [&](const std::string& file) {
        const std::string table = text_of(folder / file);
        return std::count(table.begin(), table.end(), '\n');
    };
    CHECK(rows("bullet/bodies.csv") == rows("scree/bodies.csv"));
    CHECK(rows("bullet/energy.csv") == rows("scree/energy.csv"));
    CHECK_THAT(text_of(folder / "bullet/contacts.csv"), Catch::Contains("\n0.1,ground,block,"));
}

TEST_CASE("The same scene gives the same bytes", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    const std::string method = GENERATE("bdf", "bullet");
    const std::vector<std::string> settings = {"--set", "bodies.1.velocity=[1,0.5,0]", "--quiet", "--set",
                                               "stepping.method=" + method};
    for (const char* out : {"first", "second"}) {
        std::vector<std::string> words = {"run", scene, "--out", folder / out};
        words.insert(words.end(), settings.begin(), settings.end());
        errors_of(folder, words, 0);
    }
    CHECK(text_of(folder / "first/bodies.csv") == text_of(folder / "second/bodies.csv"));
}

TEST_CASE("A run until a time stops at the last output time before it", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    errors_of(folder, {"run", scene, "--out", folder / "out", "--quiet", "--until", "0.07"}, 0);
    CHECK(summary_in(folder / "out").at("reached") == 3 * 0.02);
    CHECK(summary_in(folder / "out").at("end_time") == 0.1);
}

TEST_CASE("Bad input is refused by one line, and nothing is written", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    const std::string out = folder / "out";
    const auto run_with = [&](const std::string& setting) {
        return std::vector<std::string>{"run", scene, "--out", out, "--set", setting};
    };
    check_refused(folder, run_with("gravitty=3"), "gravitty: found an unknown key");
    check_refused(folder, run_with("shapes.s={\"mesh\": \"none.obj\"}"), "shapes.s.mesh: ");
    check_refused(folder, run_with("bodies.1.name=\"a\\nb\""), "bodies.1.name: found");
    check_refused(folder, {"run", folder.write("bad.json", "{\n\"a\"\n}"), "--out", out},
                  "bad.json:3: found");
    check_refused(folder, {"run", folder / "none.json", "--out", out}, "none.json: found no such file");
    check_refused(folder, {"run", "two\nlines", "--out", out}, "found no such file");
    check_refused(folder, {"run", folder.path().string(), "--out", out}, "found no such file");
    CHECK_FALSE(fs::exists(out));
}

TEST_CASE("Bad usage is refused by one line", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    check_refused(folder, {}, "scree: ");
    check_refused(folder, {"run"}, "SCENE");
    check_refused(folder, {"walk"}, "walk");
    check_refused(folder, {"run", scene, "--speed", "3"}, "--speed");
    check_refused(folder, {"run", scene, "--until", "-1"}, "--until");
    check_refused(folder, {"run", scene, "--until", "nan"}, "--until");
    check_refused(folder, {"run", scene, "--threads", "0"}, "--threads");
    check_refused(folder, {"run", scene, "--set"}, "--set");
    check_refused(folder, {"mesh", folder / "none.obj"}, "none.obj");
    check_refused(folder, {"mesh", cube_file, "--scale", "0"}, "scale");
    check_refused(folder, {"report"}, "PART");
    check_refused(folder, {"report", "beauty"}, "beauty");
    check_refused(folder, {"report", "cost", "--only", "beauty", "--out", folder / "out"},
                  "--only beauty: found no such problem, axis or table");
    check_refused(folder, {"resume"}, "DIR");
    check_refused(folder, {"resume", folder / "out", "--until", "soon"}, "--until");
}

TEST_CASE("What cannot be written ends with status 4", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    const std::string file = folder.write("file", "in the way");
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"run", scene}, std::vector<std::string>{"report", "cost"}}) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {"--out", file + "/out", "--quiet"});
        const std::string errors = errors_of(folder, all, 4);
        CHECK_THAT(errors, Catch::Contains("file/out: found "));
        CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
    }
}

TEST_CASE("Ctrl-C leaves what there is and ends with status 130", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    const Child child(
        folder, {"run", scene, "--out", folder / "out", "--set", "end_time=1e7", "--set", "output.every=1"});
    const auto rows = [&] {
        const std::string table = text_of(folder / "out/bodies.csv");
        return std::count(table.begin(), table.end(), '\n');
    };
    for (int i = 0; i < 1000 && rows() < 10; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    child.send(SIGINT);
    CHECK(child.wait() == 130);
    const json summary = summary_in(folder / "out");
    CHECK(summary.at("status") == "interrupted");
    const auto ticks = static_cast<long>(summary.at("reached").get<double>());
    CHECK(rows() == 1 + 3 * (ticks + 1));
    CHECK(child.errors().empty());
}

TEST_CASE("Help, version, list and check exit 0", "[cli]") {
    const Folder folder;
    const std::string scene = folder.write("small.json", small_scene);
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--help"},
                                                                                       {"--version"},
                                                                                       {"report", "--help"},
                                                                                       {"run", "--help"},
                                                                                       {"mesh", "--help"},
                                                                                       {"list"},
                                                                                       {"check", scene}}) {
        const Child child(folder, words);
        CHECK(child.wait() == 0);
        CHECK_FALSE(child.output().empty());
        CHECK(child.errors().empty());
    }
    const Child list(folder, {"list"});
    CHECK(list.wait() == 0);
    CHECK_THAT(list.output(), Catch::Contains("incline") && Catch::Contains("pile"));
    CHECK(fs::directory_iterator(folder.path()) != fs::directory_iterator());
    CHECK_FALSE(fs::exists(folder / "out"));
}

TEST_CASE("A mesh is described in JSON", "[cli]") {
    const Folder folder;
    const Child child(folder, {"mesh", cube_file, "--json", "--scale", "2"});
    REQUIRE(child.wait() == 0);
    const json mesh = json::parse(child.output());
    CHECK(mesh.at("volume") == 8);
    CHECK(mesh.at("vertices") == 8);
    CHECK(mesh.at("faces") == 6);
    CHECK(mesh.at("closed") == true);
    CHECK(mesh.at("convex") == true);
    CHECK(mesh.at("hull_volume") == 8);
    CHECK(mesh.at("inertia")[2][2] == Approx(8 * 4 / 6.0));
}

TEST_CASE("Bad meshes are refused by one line, and nothing is written", "[cli]") {
    const Folder folder;
    const MeshFiles files;
    for (const auto& [file, message] : bad_meshes(files)) {
        check_refused(folder, {"mesh", file.string()}, message);
        const std::string shape = "shapes.s={\"mesh\": \"" + file.string() + "\"}";
        const std::string scene = folder.write("small.json", small_scene);
        check_refused(folder, {"run", scene, "--out", folder / "out", "--set", shape}, message);
        CHECK_FALSE(fs::exists(folder / "out"));
    }
}

TEST_CASE("Every bad scene is refused by one line, and nothing is written", "[cli]") {
    const Folder folder;
    for (const auto& scenes : {bad_texts(), bad_values(), absent_values()}) {
        for (const BadScene& bad : scenes) {
            std::vector<std::string> words = {"run", folder.write("small.json", bad.text), "--out",
                                              folder / "out"};
            if (!bad.setting.empty()) {
                words.insert(words.end(), {"--set", bad.setting});
            }
            check_refused(folder, words, bad.message);
        }
    }
    CHECK_FALSE(fs::exists(folder / "out"));
}
