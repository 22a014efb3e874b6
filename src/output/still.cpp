// A replay stopped at one time.

#include <algorithm>
#include <stdexcept>

#include <scree/mesh/vectors.hpp>
#include <scree/output/gltf.hpp>

#include "glb_file.hpp"

namespace scree {

namespace {

using Json = nlohmann::ordered_json;

/// A place between two keys: the first's number and the share of the second.
struct Place {
    std::size_t key = 0;
    double share = 0;
};

Place place_of(double time, const std::vector<float>& times) {
    const auto after = std::upper_bound(times.begin(), times.end(), static_cast<float>(time));
    if (after == times.begin() || after == times.end()) {
        return {after == times.begin() || times.empty() ? 0 : times.size() - 1, 0};
    }
    const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
    return {key, (time - times[key]) / (static_cast<double>(*after) - times[key])};
}

Eigen::Vector4d key_at(const std::vector<float>& numbers, std::size_t key, std::size_t size) {
    Eigen::Vector4d value = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < size && key * size + i < numbers.size(); ++i) {
        value[static_cast<Eigen::Index>(i)] = numbers[key * size + i];
    }
    return value;
}

Eigen::Vector4d between(const std::vector<float>& numbers, const Place& place, std::size_t size) {
    const Eigen::Vector4d first = key_at(numbers, place.key, size);
    if (place.share == 0) {
        return first;
    }
    const Eigen::Vector4d second = key_at(numbers, place.key + 1, size);
    return size == 4 ? Quat(first).slerp(place.share, Quat(second)).coeffs()
                     : Eigen::Vector4d(first + place.share * (second - first));
}

void put_nodes(double time, GlbFile& file) {
    const Json& animation = file.json.at("animations").at(0);
    for (const Json& channel : animation.at("channels")) {
        const Json& sampler = animation.at("samplers").at(channel.at("sampler").get<std::size_t>());
        const std::vector<float> times = file.numbers(sampler.at("input").get<std::size_t>());
        const std::vector<float> values = file.numbers(sampler.at("output").get<std::size_t>());
        const Json& target = channel.at("target");
        const auto path = target.at("path").get<std::string>();
        const std::size_t size = path == "rotation" ? 4 : 3;
        const Eigen::Vector4d value = between(values, place_of(time, times), size);
        Json& entry = file.json.at("nodes").at(target.at("node").get<std::size_t>())[path];
        entry = std::vector<double>(value.data(), value.data() + size);
    }
}

// The exporter writes what an animation needs behind everything else.
void drop_animation(GlbFile& file) {
    Json& json = file.json;
    std::size_t first = json.at("accessors").size();
    for (const Json& sampler : json.at("animations").at(0).at("samplers")) {
        first = std::min(
            {first, sampler.at("input").get<std::size_t>(), sampler.at("output").get<std::size_t>()});
    }
    const auto view = json.at("accessors").at(first).at("bufferView").get<std::size_t>();
    const auto size = json.at("bufferViews").at(view).value("byteOffset", std::size_t{0});
    json.erase("animations");
    json["accessors"].erase(json["accessors"].begin() + static_cast<std::ptrdiff_t>(first),
                            json["accessors"].end());
    json["bufferViews"].erase(json["bufferViews"].begin() + static_cast<std::ptrdiff_t>(view),
                              json["bufferViews"].end());
    file.binary.resize(std::min(size, file.binary.size()));
    json["buffers"].at(0)["byteLength"] = file.binary.size();
}

}  // namespace

std::string still_of_replay(std::string_view replay, double time) {
    GlbFile file(replay);
    try {
        if (file.json.contains("animations")) {
            put_nodes(time, file);
            drop_animation(file);
        }
    } catch (const Json::exception&) {
        throw std::runtime_error("found a glTF file without a replay, expected one that scree has written");
    }
    return file.bytes();
}

}  // namespace scree
