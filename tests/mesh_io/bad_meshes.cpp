#include <algorithm>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include <scree/mesh_io/describe_mesh.hpp>

#include <tests/support/bad_meshes.hpp>

using namespace scree;
using namespace scree::test;

namespace {

/// What refuses a file; empty when it is taken for a mesh.
std::string refusal(const std::filesystem::path& file) {
    try {
        describe_mesh(file);
    } catch (const MeshError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("Files without a usable mesh are refused by name, what was found and what was expected",
          "[mesh_io]") {
    const MeshFiles files;
    const std::vector<BadMesh> bad = bad_meshes(files);
    CHECK(bad.size() >= 100);
    for (const auto& [file, message] : bad) {
        CAPTURE(file);
        const std::string found = refusal(file);
        CHECK_THAT(found, Catch::StartsWith(file.string() + ": "));
        CHECK_THAT(found, Catch::Contains(message) && Catch::Contains("expected"));
        CHECK(found.size() < 400 + file.string().size());
    }
}

TEST_CASE("A file that may not be read is refused", "[mesh_io]") {
    const MeshFiles files;
    const std::filesystem::path file = files.obj("secret.obj", cube_mesh());
    std::filesystem::permissions(file, std::filesystem::perms::none);
    if (std::ifstream(file).is_open()) {
        return;  // whoever runs this may read everything
    }
    CHECK_THAT(refusal(file), Catch::Contains("it cannot be read"));
}
