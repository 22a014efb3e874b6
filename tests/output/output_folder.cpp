#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include <scree/output/output_folder.hpp>

using namespace scree;

namespace {

namespace fs = std::filesystem;

class Place {
  public:
    Place() { fs::remove_all(path); }
    ~Place() { fs::remove_all(path); }
    fs::path path = fs::temp_directory_path() / "scree_output_folder";
};

}  // namespace

TEST_CASE("A new run replaces the files of an old one, and no others", "[output]") {
    const Place place;
    const OutputFolder first(place.path / "run");
    for (const char* name : {"summary.json", "bodies.csv", "energy.csv", "notes.txt"}) {
        std::ofstream(first.file(name)) << "old";
    }
    fs::create_directories(first.file("frames"));
    const OutputFolder second(place.path / "run");
    CHECK_FALSE(fs::exists(second.file("summary.json")));
    CHECK_FALSE(fs::exists(second.file("bodies.csv")));
    CHECK_FALSE(fs::exists(second.file("energy.csv")));
    CHECK_FALSE(fs::exists(second.file("frames")));
    CHECK(fs::exists(second.file("notes.txt")));
}

TEST_CASE("A folder that cannot be made is refused by name", "[output]") {
    const Place place;
    fs::create_directories(place.path);
    std::ofstream(place.path / "file") << "in the way";
    CHECK_THROWS_WITH(OutputFolder(place.path / "file" / "run"), Catch::Contains("file/run: found "));
    CHECK_THROWS_AS(OutputFolder(place.path / "file"), OutputError);
}

TEST_CASE("A whole file is written under another name first", "[output]") {
    const Place place;
    fs::create_directories(place.path);
    const fs::path file = place.path / "whole";
    write_whole(file, "one");
    write_whole(file, "two");
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    CHECK(text.str() == "two");
    CHECK(std::distance(fs::directory_iterator(place.path), fs::directory_iterator()) == 1);
    CHECK_THROWS_AS(write_whole(place.path / "no" / "whole", "text"), OutputError);
}
