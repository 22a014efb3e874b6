#include <bit>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include <catch2/catch.hpp>

#include <scree/output/bodies_csv.hpp>
#include <scree/output/output_folder.hpp>

using namespace scree;

namespace {

namespace fs = std::filesystem;

const fs::path table = fs::temp_directory_path() / "scree_csv_file.csv";

std::string contents() {
    std::ifstream stream(table);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

double read_back(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    REQUIRE(end == text.data() + text.size());
    return value;
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

TEST_CASE("Every double reads back as itself", "[output]") {
    std::mt19937_64 bits(5);
    int tried = 0;
    while (tried < 100'000) {
        const auto value = std::bit_cast<double>(bits());
        if (!std::isfinite(value)) {
            continue;
        }
        ++tried;
        std::string text;
        append_number(text, value);
        if (!same_bits(read_back(text), value)) {
            FAIL("not read back: " << text);
        }
    }
    for (const double value : {0.0, -0.0, 0.1, 1e23, 5e-324, std::numeric_limits<double>::max()}) {
        std::string text;
        append_number(text, value);
        CHECK(same_bits(read_back(text), value));
    }
}

TEST_CASE("bodies.csv has one row a body and time, in order", "[output]") {
    {
        BodiesCsv csv(table);
        const std::vector<BodyRecord> bodies = {
            {"ground", {}, Vec3::Zero(), Vec3::Zero()},
            {"a, \"b\"", {{1, 2, 3}, Quat(0.5, -0.5, 0.5, 0.5)}, {4, 5, 6}, {7, 8, 0.1}}};
        csv.write(0, bodies);
        csv.write(0.25, bodies);
    }
    CHECK(contents() ==
          "t,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n"
          "0,ground,0,0,0,1,0,0,0,0,0,0,0,0,0\n"
          "0,\"a, \"\"b\"\"\",1,2,3,0.5,-0.5,0.5,0.5,4,5,6,7,8,0.1\n"
          "0.25,ground,0,0,0,1,0,0,0,0,0,0,0,0,0\n"
          "0.25,\"a, \"\"b\"\"\",1,2,3,0.5,-0.5,0.5,0.5,4,5,6,7,8,0.1\n");
    fs::remove(table);
}

TEST_CASE("A table that cannot be written says so", "[output]") {
    CHECK_THROWS_AS(CsvFile("no/such/folder/table.csv", "a"), OutputError);
    CHECK_THROWS_WITH(CsvFile("/dev/full", "a"), Catch::Contains("/dev/full: found No space left"));
}
