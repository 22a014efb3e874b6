#include <tests/support/glb.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include <catch2/catch.hpp>

namespace scree::test {

namespace {

using nlohmann::json;

constexpr int float_type = 5126;
constexpr int unsigned_type = 5125;
constexpr int short_type = 5123;
constexpr int byte_type = 5121;

std::uint32_t word_at(const std::string& bytes, std::size_t place) {
    std::uint32_t word = 0;
    REQUIRE(place + sizeof word <= bytes.size());
    std::memcpy(&word, bytes.data() + place, sizeof word);
    return word;
}

std::size_t components(const json& accessor) {
    static const std::map<std::string, std::size_t> known = {{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
    return known.at(accessor.at("type"));
}

std::size_t bytes_of(int type) {
    return type == byte_type ? 1 : type == short_type ? 2 : 4;
}

double number_at(const char* place, int type) {
    if (type == float_type) {
        float value = 0;
        std::memcpy(&value, place, sizeof value);
        return value;
    }
    std::uint32_t value = 0;
    std::memcpy(&value, place, bytes_of(type));
    return value;
}

void check_bounds(const Glb& glb, const json& accessor, std::size_t number) {
    const std::vector<double> numbers = glb.numbers(number);
    const std::size_t size = components(accessor);
    for (std::size_t c = 0; c < size && accessor.contains("min"); ++c) {
        double low = INFINITY;
        double high = -INFINITY;
        for (std::size_t i = c; i < numbers.size(); i += size) {
            low = std::min(low, numbers[i]);
            high = std::max(high, numbers[i]);
        }
        CHECK(accessor["min"][c].get<float>() == static_cast<float>(low));
        CHECK(accessor["max"][c].get<float>() == static_cast<float>(high));
    }
}

void check_unit(const std::vector<double>& numbers, std::size_t size) {
    double worst = 0;
    for (std::size_t i = 0; i < numbers.size(); i += size) {
        double square = 0;
        for (std::size_t c = 0; c < size; ++c) {
            square += numbers[i + c] * numbers[i + c];
        }
        worst = std::max(worst, std::abs(square - 1));
    }
    CHECK(worst < 1e-5);
}

void check_meshes(const Glb& glb) {
    for (const json& mesh : glb.json.at("meshes")) {
        for (const json& part : mesh.at("primitives")) {
            const json& attributes = part.at("attributes");
            const auto positions = glb.numbers(attributes.at("POSITION"));
            const auto normals = glb.numbers(attributes.at("NORMAL"));
            const auto indices = glb.numbers(part.at("indices"));
            CHECK(glb.json["accessors"][attributes["POSITION"].get<std::size_t>()].contains("min"));
            CHECK(positions.size() == normals.size());
            CHECK(indices.size() % 3 == 0);
            CHECK_FALSE(indices.empty());
            CHECK(3 * *std::max_element(indices.begin(), indices.end()) <
                  static_cast<double>(positions.size()));
            CHECK(part.at("material") < glb.json.at("materials").size());
            check_unit(normals, 3);
        }
    }
}

void check_nodes(const Glb& glb) {
    const json& nodes = glb.json.at("nodes");
    for (const json& node : nodes) {
        CHECK((!node.contains("mesh") || node["mesh"] < glb.json["meshes"].size()));
        for (const json& child : node.value("children", json::array())) {
            CHECK(child < nodes.size());
        }
    }
    for (const json& root : glb.json.at("scenes").at(glb.json.at("scene").get<std::size_t>()).at("nodes")) {
        CHECK(root < nodes.size());
    }
}

void check_animation(const Glb& glb, const json& animation) {
    for (const json& channel : animation.at("channels")) {
        const json& sampler = animation.at("samplers").at(channel.at("sampler").get<std::size_t>());
        const auto times = glb.numbers(sampler.at("input"));
        const auto values = glb.numbers(sampler.at("output"));
        const std::string path = channel.at("target").at("path");
        const std::size_t size = path == "rotation" ? 4 : 3;
        CHECK(glb.json["accessors"][sampler["input"].get<std::size_t>()].contains("max"));
        CHECK(times.front() >= 0);
        CHECK(std::is_sorted(times.begin(), times.end(), std::less_equal<>()));
        CHECK(values.size() == size * times.size());
        CHECK_FALSE(glb.json["nodes"].at(channel["target"].at("node").get<std::size_t>()).contains("matrix"));
        if (size == 4) {
            check_unit(values, 4);
        }
    }
}

}  // namespace

Glb::Glb(const std::string& bytes) {
    REQUIRE(bytes.substr(0, 4) == "glTF");
    CHECK(word_at(bytes, 4) == 2);
    CHECK(word_at(bytes, 8) == bytes.size());
    const std::size_t size = word_at(bytes, 12);
    CHECK(bytes.substr(16, 4) == "JSON");
    CHECK(size % 4 == 0);
    json = json::parse(bytes.substr(20, size));
    const std::size_t rest = word_at(bytes, 20 + size);
    CHECK(bytes.substr(24 + size, 4) == std::string("BIN\0", 4));
    binary = bytes.substr(28 + size);
    CHECK(binary.size() == rest);
    CHECK(json.at("buffers").size() == 1);
    CHECK(json["buffers"][0].at("byteLength") <= rest);
    CHECK(json["buffers"][0]["byteLength"] >= rest - 3);
}

std::vector<double> Glb::numbers(std::size_t number) const {
    const auto& accessor = json.at("accessors").at(number);
    const auto& view = json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    const int type = accessor.at("componentType");
    const std::size_t count = accessor.at("count").get<std::size_t>() * components(accessor);
    const std::size_t offset = accessor.value("byteOffset", std::size_t{0});
    const std::size_t begin = view.value("byteOffset", std::size_t{0});
    CHECK(offset + count * bytes_of(type) <= view.at("byteLength"));
    REQUIRE(begin + view.at("byteLength").get<std::size_t>() <= binary.size());
    CHECK((begin + offset) % bytes_of(type) == 0);
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        numbers.push_back(number_at(binary.data() + begin + offset + i * bytes_of(type), type));
    }
    return numbers;
}

void check_glb(const Glb& glb) {
    CHECK(glb.json.at("asset").at("version") == "2.0");
    CHECK_FALSE(glb.json.contains("extensionsRequired"));
    for (std::size_t i = 0; i < glb.json.at("accessors").size(); ++i) {
        check_bounds(glb, glb.json["accessors"][i], i);
    }
    check_meshes(glb);
    check_nodes(glb);
    for (const json& animation : glb.json.value("animations", json::array())) {
        check_animation(glb, animation);
    }
}

}  // namespace scree::test
