#include <limits>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/output/checkpoint.hpp>

#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

Checkpoint some_checkpoint() {
    Checkpoint checkpoint;
    checkpoint.scene = "{\"name\": \"é\"}";
    checkpoint.scene_file = "somewhere/scene.json";
    checkpoint.shapes["ball"] = {{0.05}, {2}};
    checkpoint.files["bodies.csv"] = 123456789012;
    checkpoint.wall = 1.25;
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        checkpoint.state.numbers.push_back(random.uniform(-1, 1));
        checkpoint.state.counts.push_back(static_cast<std::uint64_t>(i));
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {0.0, -0.0, 0.1, 1e-310, 5e-324, infinity, -infinity, 1.5F * 1.0}) {
        checkpoint.state.numbers.push_back(value);
    }
    checkpoint.state.counts.push_back(std::numeric_limits<std::uint64_t>::max());
    return checkpoint;
}

std::string message_of(std::string_view bytes) {
    try {
        parse_checkpoint(bytes);
    } catch (const CheckpointError& error) {
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& old, const std::string& with) {
    return text.replace(text.find(old), old.size(), with);
}

}  // namespace

TEST_CASE("A checkpoint comes back to the last bit", "[output]") {
    const Checkpoint checkpoint = some_checkpoint();
    const std::string bytes = checkpoint_bytes(checkpoint);
    const Checkpoint back = parse_checkpoint(bytes);
    CHECK(back.scene == checkpoint.scene);
    CHECK(back.scene_file == checkpoint.scene_file);
    CHECK(back.shapes == checkpoint.shapes);
    CHECK(back.files == checkpoint.files);
    CHECK(back.wall == 1.25);
    CHECK(back.state == checkpoint.state);
    CHECK(std::signbit(back.state.numbers[1001]));
    CHECK(checkpoint_bytes(back) == bytes);
}

TEST_CASE("A checkpoint that is cut short is refused, wherever it is cut", "[output]") {
    const std::string bytes = checkpoint_bytes(some_checkpoint());
    for (std::size_t size = 0; size < bytes.size(); size += size < 200 ? 1 : 97) {
        CHECK_THAT(message_of(bytes.substr(0, size)), Catch::StartsWith("found "));
    }
    CHECK_THAT(message_of(bytes.substr(0, bytes.size() - 1)), Catch::Contains("it is not whole"));
    CHECK_THAT(message_of(bytes + "x"), Catch::Contains("it is not whole"));
    CHECK(message_of("") == "found another file, expected a checkpoint");
}

TEST_CASE("A checkpoint in which one bit is another is refused", "[output]") {
    const std::string bytes = checkpoint_bytes(some_checkpoint());
    for (std::size_t i = 0; i < bytes.size(); i += i < 200 ? 1 : 61) {
        std::string altered = bytes;
        altered[i] = static_cast<char>(altered[i] ^ 4);
        CAPTURE(i);
        CHECK_THAT(message_of(altered), Catch::StartsWith("found "));
    }
}

TEST_CASE("Checkpoints of other formats and versions are refused by name", "[output]") {
    const std::string bytes = checkpoint_bytes(some_checkpoint());
    CHECK(message_of(replaced(bytes, "checkpoint 1", "checkpoint 2")) == "found format 2, expected 1");
    CHECK_THAT(message_of("scree checkpoint \n"), Catch::Contains("another first line"));
    CHECK_THAT(message_of("scree checkpoint 99999999999999999999 1 1\n"), Catch::Contains("first line"));
}

TEST_CASE("Contents that no checkpoint has are refused, with the right checksum too", "[output]") {
    const auto with_contents = [](const nlohmann::json& json) {
        std::string cbor;
        nlohmann::json::to_cbor(json, cbor);
        return message_of(sealed_checkpoint(cbor));
    };
    CHECK(with_contents(nlohmann::json::object()) == "found other contents, expected those of a checkpoint");
    CHECK(with_contents({1, 2}) == "found other contents, expected those of a checkpoint");
    CHECK_THAT(with_contents({{"scree", "0.0.1"}}), Catch::Contains("found one of scree 0.0.1"));
    CHECK_THAT(message_of(sealed_checkpoint(std::string(1 << 20, '\x81'))), Catch::Contains("nested deeper"));
    CHECK_THAT(message_of(sealed_checkpoint(std::string(9, '\x9b'))), Catch::Contains("other contents"));
}
