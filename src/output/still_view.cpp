// What a picture of a still needs to know: where to look, and enough light.

#include <algorithm>
#include <cmath>

#include <scree/mesh/vectors.hpp>
#include <scree/output/gltf.hpp>

#include "glb_file.hpp"

namespace scree {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t ground_corners = 6;
constexpr double far_out = 2;  // times the mean square distance: what is farther has left the scene

struct Ball {
    Vec3 centre;
    double radius;
};

Vec3 vector_of(const Json& numbers, std::size_t first = 0) {
    return {numbers.at(first).get<double>(), numbers.at(first + 1).get<double>(),
            numbers.at(first + 2).get<double>()};
}

Eigen::Affine3d placed(const Json& node) {
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    if (node.contains("matrix")) {
        const auto numbers = node.at("matrix").get<std::vector<double>>();
        place.matrix() = Eigen::Map<const Eigen::Matrix4d>(numbers.data());
        return place;
    }
    if (node.contains("translation")) {
        place.translate(vector_of(node.at("translation")));
    }
    if (const auto q = node.value("rotation", std::vector<double>{0, 0, 0, 1}); q.size() == 4) {
        place.rotate(Quat(q[3], q[0], q[1], q[2]).normalized());
    }
    if (node.contains("scale")) {
        place.scale(vector_of(node.at("scale")));
    }
    return place;
}

/// About each body that is not ground.
std::vector<Ball> balls_of(const Json& json) {
    std::vector<Ball> balls;
    for (const Json& node : json.at("nodes")) {
        if (!node.contains("mesh")) {
            continue;
        }
        const Json& mesh = json.at("meshes").at(node.at("mesh").get<std::size_t>());
        const auto accessor = mesh.at("primitives").at(0).at("attributes").at("POSITION").get<std::size_t>();
        const Json& corners = json.at("accessors").at(accessor);
        if (corners.at("count").get<std::size_t>() <= ground_corners) {
            continue;
        }
        const Vec3 low = vector_of(corners.at("min"));
        const Vec3 high = vector_of(corners.at("max"));
        const Eigen::Affine3d place = placed(node);
        const double size = std::cbrt(std::abs(place.linear().determinant()));
        balls.push_back({place * Vec3(0.5 * (low + high)), 0.5 * size * (high - low).norm()});
    }
    return balls;
}

}  // namespace

StillView view_of_still(std::string_view still) {
    const std::vector<Ball> balls = balls_of(GlbFile(still).json);
    if (balls.empty()) {
        return {};
    }
    const auto count = static_cast<double>(balls.size());
    Vec3 middle = Vec3::Zero();
    for (const Ball& ball : balls) {
        middle += ball.centre / count;
    }
    double spread = 0;
    for (const Ball& ball : balls) {
        spread += (ball.centre - middle).squaredNorm() / count;
    }
    double radius = 0;
    for (const Ball& ball : balls) {
        const double distance = std::min((ball.centre - middle).norm(), far_out * std::sqrt(spread));
        radius = std::max(radius, distance + ball.radius);
    }
    // The root turns z up to y up.
    return {{middle.x(), middle.z(), -middle.y()}, radius};
}

std::string brightened(std::string_view still, double factor) {
    GlbFile file(still);
    for (Json& material : file.json.at("materials")) {
        Json& colour = material.at("pbrMetallicRoughness").at("baseColorFactor");
        for (const std::size_t part : {0, 1, 2}) {
            colour.at(part) = std::min(1.0, factor * colour.at(part).get<double>());
        }
    }
    return file.bytes();
}

}  // namespace scree
