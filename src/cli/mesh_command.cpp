#include <cstdio>
#include <nlohmann/json.hpp>

#include <scree/mesh_io/describe_mesh.hpp>
#include <scree/scenes/scene_error.hpp>

#include "commands.hpp"

namespace scree {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

Json json_of(const MeshDescription& mesh) {
    Json json;
    json["volume"] = mesh.mass.volume;
    json["centroid"] = json_of(mesh.mass.centroid);
    for (int row = 0; row < 3; ++row) {
        json["inertia"].push_back(json_of(mesh.mass.inertia.row(row)));
    }
    json["vertices"] = mesh.vertices();
    json["faces"] = mesh.faces();
    json["closed"] = mesh.closed;
    json["convex"] = mesh.convex;
    json["hull_volume"] = mesh.hull_volume();
    return json;
}

void print(const std::string& file, const MeshDescription& mesh) {
    const Vec3& centroid = mesh.mass.centroid;
    const Vec3& moments = mesh.mass.principal_inertia;
    std::printf("%s: %s, %s\n", file.c_str(), mesh.closed ? "closed" : "not closed, taken by its hull",
                mesh.convex ? "convex" : "not convex");
    std::printf("volume             %.10g m³\n", mesh.mass.volume);
    std::printf("centroid           %.10g %.10g %.10g m\n", centroid.x(), centroid.y(), centroid.z());
    std::printf("principal inertia  %.10g %.10g %.10g m⁵ (for density 1)\n", moments.x(), moments.y(),
                moments.z());
    std::printf("hull               %d vertices, %d faces, volume %.10g m³ (the mesh fills %.6g of it)\n",
                mesh.vertices(), mesh.faces(), mesh.hull_volume(), mesh.volume_ratio());
    std::printf("vertices moved     %.3g m at most, to make merged faces planar\n", mesh.hull.largest_move);
}

}  // namespace

int mesh_command(const MeshRequest& request) {
    MeshDescription mesh;
    try {
        mesh = describe_mesh(request.file, Vec3::Constant(request.scale));
    } catch (const std::exception& error) {
        throw SceneError(error.what());
    }
    if (request.json) {
        std::printf("%s\n", json_of(mesh).dump(2).c_str());
    } else if (!request.quiet) {
        print(request.file, mesh);
    }
    return exit_done;
}

}  // namespace scree
