// What fuzzing has found, and where it starts, in every run of the tests.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <tests/fuzz/targets.hpp>

using namespace scree::test;

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> corpus(const std::string& target) {
    std::vector<fs::path> files;
    for (const auto& entry :
         fs::directory_iterator(fs::path(SCREE_SOURCE_DIR) / "tests/fuzz/corpus" / target)) {
        files.push_back(entry.path());
    }
    return files;
}

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("The kept scenes of the fuzzer are accepted or refused by one line", "[fuzz]") {
    CHECK(corpus("scene").size() >= 10);
    for (const fs::path& file : corpus("scene")) {
        INFO(file);
        CHECK_NOTHROW(try_scene(bytes_of(file)));
    }
}

TEST_CASE("The kept meshes of the fuzzer are accepted or refused by one line", "[fuzz]") {
    CHECK(corpus("mesh").size() >= 10);
    for (const fs::path& file : corpus("mesh")) {
        INFO(file);
        CHECK_NOTHROW(try_mesh(bytes_of(file)));
    }
}

TEST_CASE("The kept checkpoints of the fuzzer are accepted or refused by one line", "[fuzz]") {
    CHECK(corpus("checkpoint").size() >= 5);
    for (const fs::path& file : corpus("checkpoint")) {
        INFO(file);
        CHECK_NOTHROW(try_checkpoint(bytes_of(file)));
    }
}
