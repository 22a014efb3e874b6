#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

std::vector<std::string> lines_of(const std::string& name) {
    std::ifstream file(std::filesystem::path(SCREE_SOURCE_DIR) / "demos/bullet_program" / name);
    REQUIRE(file.good());
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) {
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

TEST_CASE("the two versions of the Bullet program differ in the line that constructs the world") {
    const std::vector<std::string> bullet = lines_of("with_bullet.cpp");
    const std::vector<std::string> scree = lines_of("with_scree.cpp");
    REQUIRE(bullet.size() == scree.size());
    std::vector<std::size_t> different;
    for (std::size_t i = 0; i < bullet.size(); ++i) {
        if (bullet[i] != scree[i]) {
            different.push_back(i);
        }
    }
    REQUIRE(different.size() == 1);
    CHECK_THAT(bullet[different[0]], Catch::Contains("btDiscreteDynamicsWorld world("));
    CHECK_THAT(scree[different[0]], Catch::Contains("scree::DynamicsWorld world("));
}
